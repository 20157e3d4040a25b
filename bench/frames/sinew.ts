import { openCharacter } from '../../src/document/open-characters.ts';
import { setPose } from '../../src/document/edits.ts';
import { unmoved } from '../../src/document/scene.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { drawApart, holdMoment } from '../../src/view/picture/held-moment.ts';
import { captureFrame } from '../../src/view/picture/make-picture.ts';
import { refinement } from '../../src/view/refinement.ts';
import { Viewer } from '../../src/view/viewer.ts';
import { characterOf } from '../data/character.ts';
import { cylinder, poseAngles } from '../data/cylinder.ts';
import { azimuthOf, pictureHeight, pictureWidth, startCamera } from './picture.ts';
import { createCanvas, offerFrames } from './page.ts';

// Frames are measured as they are after the first one.
await refinement.load();

/** Draws with the product's viewer on a page without panels. Actors stand in a square. */
offerFrames(({ vertexCount, jointCount, actorCount, unskinned }) => {
  const canvas = createCanvas();
  const session = new Session();
  const store = new Store();
  const evaluations = new Evaluations(store, session);
  const viewer = new Viewer(canvas, store, session, evaluations, () => undefined);
  viewer.connect({});
  const body = cylinder({ vertexCount, jointCount });
  const character = characterOf(unskinned ? { ...body, joints: body.joints.fill(1) } : body);
  const rowLength = Math.ceil(Math.sqrt(actorCount));
  for (let i = 0; i < actorCount; i++) {
    const position = [0.5 * (i % rowLength), 0, -0.5 * Math.floor(i / rowLength)] as const;
    const transform = { ...unmoved, position };
    store.dispatch(openCharacter(null, character, 'linear-blend', { transform }));
  }
  const { actors } = store.scene.value;
  viewer.resize(pictureWidth, pictureHeight);
  viewer.camera.value = { ...startCamera, projection: 'perspective' };
  if (actorCount > 1) viewer.frameAll();
  viewer.drawNow();
  const { azimuth } = viewer.camera.value;
  // One long drag: it adds one step to the history at most.
  const drag = store.begin('Pose');
  return {
    gl: canvas.getContext('webgl2')!,
    posed(index) {
      const edits = actors.map(({ id }, i) => setPose(id, poseAngles(jointCount, index + 0.6 * i)));
      drag.preview({
        label: 'Pose',
        apply: (scene) => edits.reduce((posed, edit) => edit.apply(posed), scene),
      });
      viewer.drawNow();
    },
    camera(index) {
      const turn = azimuthOf(index) - startCamera.azimuth;
      viewer.camera.value = { ...viewer.camera.value, azimuth: azimuth + turn };
      viewer.drawNow();
    },
    still() {
      viewer.camera.value = { ...viewer.camera.value };
      viewer.drawNow();
    },
    silhouette() {
      const size = { width: pictureWidth, height: pictureHeight };
      const held = holdMoment(viewer);
      const view = { ...viewer.contents[0]!, viewport: { x: 0, y: 0, ...size } };
      const pixels = drawApart(viewer, view, held.shown, { showSurroundings: false }, captureFrame);
      held.release();
      return Uint8Array.from({ length: pixels.length / 4 }, (_, i) => pixels[i * 4 + 3]! >> 7);
    },
  };
});
