import * as three from 'three';
import { cylinder, poseAngles } from '../data/cylinder.ts';
import { createCanvas, offerFrames } from '../frames/page.ts';
import { azimuthOf, pictureHeight, pictureWidth } from '../frames/picture.ts';
import { skinnedMeshOf } from './three-body.mjs';
import { aim, clay, createStudio } from './three-studio.mjs';

/** Draws with three.js what Sinew's viewer draws. */
offerFrames(({ vertexCount, shadowSize }) => {
  const studio = createStudio(createCanvas(), pictureWidth, pictureHeight, shadowSize);
  const { renderer, scene, floor, camera } = studio;
  const { mesh, bones } = skinnedMeshOf(cylinder({ vertexCount }), clay());
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  scene.add(mesh);
  const gl = renderer.getContext();
  const silhouetteMaterial = new three.MeshBasicMaterial({ color: 0xffffff });

  return {
    gl,
    posed(index) {
      renderer.shadowMap.autoUpdate = true;
      const angles = poseAngles(bones.length, index);
      for (let i = 0; i < bones.length; i++) {
        bones[i].rotation.set(angles[3 * i], angles[3 * i + 1], angles[3 * i + 2]);
      }
      renderer.render(scene, camera);
    },
    camera(index) {
      renderer.shadowMap.autoUpdate = false;
      aim(camera, azimuthOf(index));
      renderer.render(scene, camera);
    },
    still() {
      renderer.shadowMap.autoUpdate = false;
      renderer.render(scene, camera);
    },
    silhouette() {
      const { background } = scene;
      scene.background = new three.Color(0x000000);
      scene.overrideMaterial = silhouetteMaterial;
      floor.visible = false;
      renderer.render(scene, camera);
      const pixels = new Uint8Array(pictureWidth * pictureHeight * 4);
      gl.readPixels(0, 0, pictureWidth, pictureHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      scene.background = background;
      scene.overrideMaterial = null;
      floor.visible = true;
      return Uint8Array.from({ length: pixels.length / 4 }, (_, i) => pixels[i * 4] >> 7);
    },
  };
});
