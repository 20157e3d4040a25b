import * as three from 'three';
import { lights, startCamera } from '../frames/picture.ts';

/**
 * A scene with what Sinew's studio has: three lights, of which the first throws a shadow by a
 * percentage-closer filtered map, light from all around, and a floor.
 */
export function createStudio(canvas, width, height, shadowSize) {
  const renderer = new three.WebGLRenderer({ canvas, antialias: true, alpha: false });
  renderer.setSize(width, height, false);
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

  const degrees = (startCamera.fieldOfView * 180) / Math.PI;
  const camera = new three.PerspectiveCamera(degrees, width / height, 0.05, 60);
  aim(camera, startCamera.azimuth);
  return { renderer, scene, floor, camera };
}

/** A matte surface in the color of Sinew's clay. */
export function clay() {
  return new three.MeshPhongMaterial({ color: 0xa5a29c });
}

/** Turns the camera around the body. */
export function aim(camera, azimuth) {
  const { target, distance, elevation } = startCamera;
  const level = distance * Math.cos(elevation);
  camera.position.set(
    target[0] + level * Math.sin(azimuth),
    target[1] + distance * Math.sin(elevation),
    target[2] + level * Math.cos(azimuth),
  );
  camera.lookAt(...target);
}

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
