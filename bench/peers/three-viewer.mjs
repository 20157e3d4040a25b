import { skinnedMeshOf } from './three-body.mjs';
import { clay, createStudio } from './three-studio.mjs';

/**
 * The smallest viewer of a 6.837 character with three.js: it reads the three files by `split` and
 * shows the first picture.
 */
async function show(folder, width, height) {
  const [skel, obj, attach] = await Promise.all(
    ['skel', 'obj', 'attach'].map((kind) => linesOf(`${folder}.${kind}.gz`)),
  );
  const canvas = document.body.appendChild(document.createElement('canvas'));
  canvas.width = width;
  canvas.height = height;
  const { renderer, scene, camera } = createStudio(canvas, width, height, 1024);
  const { mesh, bones } = skinnedMeshOf(bodyOf(obj, attach, skel.length), clay());
  skel.forEach((line, i) => bones[i].position.fromArray(line.split(' ').map(Number)));
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  mesh.geometry.computeBoundingBox();
  const { min, max } = mesh.geometry.boundingBox;
  mesh.scale.setScalar(1 / (max.y - min.y));
  mesh.position.y = -min.y * mesh.scale.y;
  scene.add(mesh);
  renderer.render(scene, camera);
  performance.mark('first-frame');
}

async function linesOf(address) {
  const { body } = await fetch(address);
  const text = await new Response(body.pipeThrough(new DecompressionStream('gzip'))).text();
  return text.trim().split('\n');
}

function bodyOf(obj, attach, jointCount) {
  const positions = [];
  const indices = [];
  for (const line of obj) {
    const [keyword, ...words] = line.split(' ');
    if (keyword === 'v') positions.push(...words.map(Number));
    if (keyword !== 'f') continue;
    // Faces count from the first vertex, or back from the last one before them.
    const corners = words.map((word) => {
      const index = parseInt(word, 10);
      return index < 0 ? positions.length / 3 + index : index - 1;
    });
    for (let i = 2; i < corners.length; i++) indices.push(corners[0], corners[i - 1], corners[i]);
  }
  const start = new Uint32Array(attach.length + 1);
  const joints = [];
  const weights = [];
  attach.forEach((line, vertex) => {
    line.split(' ').forEach((word, column) => {
      if (Number(word) === 0) return;
      joints.push(column + 1);
      weights.push(Number(word));
    });
    start[vertex + 1] = joints.length;
  });
  return {
    positions: Float32Array.from(positions),
    indices: Uint32Array.from(indices),
    jointCount,
    jointSpacing: 0,
    start,
    joints,
    weights,
  };
}

const parameters = new URLSearchParams(location.search);
await show('./data/human/human', Number(parameters.get('width')), Number(parameters.get('height')));
