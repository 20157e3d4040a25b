import * as three from 'three';
import { cylinder, poseAngles } from '../data/cylinder.ts';
import { createCanvas, offerFrames } from '../frames/page.ts';
import { azimuthOf, lights, pictureHeight, pictureWidth, startCamera } from '../frames/picture.ts';
import { skinnedMeshOf } from './three-body.mjs';

/**
 * Draws with three.js what Sinew's viewer draws: antialiased, lit by three lights, of which the
 * first throws a shadow by a percentage-closer filtered map of the same size, on a floor.
 */
offerFrames(({ vertexCount, shadowSize }) => {
  const canvas = createCanvas();
  const renderer = new three.WebGLRenderer({ canvas, antialias: true, alpha: false });
  renderer.setSize(pictureWidth, pictureHeight, false);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = three.PCFShadowMap;

  const scene = new three.Scene();
  scene.background = new three.Color(0xdde0e2);
  for (const [index, light] of lights.entries()) scene.add(lightOf(light, index === 0, shadowSize));
  scene.add(new three.HemisphereLight(0xd6e8ff, 0xffebd4, 0.4));
  const floor = new three.Mesh(
    new three.PlaneGeometry(48, 48).rotateX(-Math.PI / 2),
    new three.MeshPhongMaterial({ color: 0xece9e2 }),
  );
  floor.receiveShadow = true;
  scene.add(floor);

  const body = cylinder({ vertexCount });
  const { mesh, bones } = skinnedMeshOf(body, new three.MeshPhongMaterial({ color: 0xa5a29c }));
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  scene.add(mesh);

  const aspect = pictureWidth / pictureHeight;
  const degrees = (startCamera.fieldOfView * 180) / Math.PI;
  const camera = new three.PerspectiveCamera(degrees, aspect, 0.05, 60);
  aim(startCamera.azimuth);
  const silhouetteMaterial = new three.MeshBasicMaterial({ color: 0xffffff });

  return {
    gl: renderer.getContext(),
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
      aim(azimuthOf(index));
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
      const gl = renderer.getContext();
      gl.readPixels(0, 0, pictureWidth, pictureHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      scene.background = background;
      scene.overrideMaterial = null;
      floor.visible = true;
      return Uint8Array.from({ length: pixels.length / 4 }, (_, i) => pixels[i * 4] >> 7);
    },
  };

  function aim(azimuth) {
    const { target, distance, elevation } = startCamera;
    const level = distance * Math.cos(elevation);
    camera.position.set(
      target[0] + level * Math.sin(azimuth),
      target[1] + distance * Math.sin(elevation),
      target[2] + level * Math.cos(azimuth),
    );
    camera.lookAt(...target);
  }
});

function lightOf({ color, intensity, azimuth, elevation }, casts, shadowSize) {
  const light = new three.DirectionalLight(color, intensity);
  const [around, above] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  const level = Math.cos(above);
  light.position.set(Math.sin(around) * level, Math.sin(above), Math.cos(around) * level);
  light.position.multiplyScalar(3);
  if (casts) {
    light.castShadow = true;
    light.shadow.mapSize.set(shadowSize, shadowSize);
    const { camera } = light.shadow;
    Object.assign(camera, { left: -0.8, right: 0.8, top: 0.8, bottom: -0.8, near: 0.5, far: 6 });
    light.target.position.set(0, 0.5, 0);
    light.position.y += 0.5;
    light.target.updateMatrixWorld();
  }
  return light;
}
