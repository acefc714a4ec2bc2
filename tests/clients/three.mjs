// three.mjs -- reads a file with three.js and compares it with what the program says of it.
//
//   node three.mjs FILE.glb INFO.json
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { furLines, furOf } from "./three_example.mjs";

globalThis.self = globalThis; // the loader asks it for URL

// Node has no pictures, so every texture is an empty one.
class NoPictures {
  name = "no pictures";
  loadTexture() {
    return Promise.resolve(new THREE.Texture());
  }
}

// Values of an accessor, read by hand: packed floats, which is what the writer promises.
function floatsByHand(file, json, accessor) {
  const { bufferView, count, type, componentType, byteOffset = 0 } = json.accessors[accessor];
  assert.equal(componentType, 5126);
  const view = json.bufferViews[bufferView];
  const chunk = 20 + file.readUInt32LE(12) + 8;
  const start = chunk + (view.byteOffset ?? 0) + byteOffset;
  const width = { SCALAR: 1, VEC2: 2, VEC3: 3 }[type];
  const values = new Float32Array(count * width);
  for (let i = 0; i < values.length; ++i) values[i] = file.readFloatLE(start + 4 * i);
  return values;
}

function extent(values) {
  let least = Infinity;
  let greatest = -Infinity;
  for (const value of values) {
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
  }
  return { min: least, max: greatest };
}

// Both are floats; the program may print fewer digits than a double has.
function sameRange(name, is, wanted) {
  for (const end of ["min", "max"]) {
    assert.ok(Math.abs(is[end] - wanted[end]) <= 1e-6 * Math.max(1, Math.abs(wanted[end])),
      `${name} ${end} is ${is[end]}, the program says ${wanted[end]}`);
  }
}

const [path, infoPath] = process.argv.slice(2);
const file = readFileSync(path);
const info = JSON.parse(readFileSync(infoPath));
const json = JSON.parse(file.subarray(20, 20 + file.readUInt32LE(12)).toString());

const loader = new GLTFLoader().register(() => new NoPictures());
const bytes = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength);
const gltf = await loader.parseAsync(bytes, "");

const furs = furOf(gltf.scene);
assert.ok(furs.length > 0, "no mesh with fur");
const primitives = json.meshes.flatMap((mesh) => mesh.primitives);
assert.equal(furs.length, primitives.length);

const all = { length: [], density: [], direction: [] };
let vertices = 0;
let triangles = 0;
for (const [p, fur] of furs.entries()) {
  const { attributes } = primitives[p];
  assert.deepEqual(fur.length.array, floatsByHand(file, json, attributes._FUR_LENGTH));
  assert.deepEqual(fur.density.array, floatsByHand(file, json, attributes._FUR_DENSITY));
  assert.deepEqual(fur.direction.array, floatsByHand(file, json, attributes._FUR_DIRECTION));
  all.length.push(...fur.length.array);
  all.density.push(...fur.density.array);
  const d = fur.direction.array;
  for (let i = 0; i < d.length; i += 3) all.direction.push(Math.hypot(d[i], d[i + 1], d[i + 2]));

  assert.equal(fur.coats.version, 1);
  assert.deepEqual(fur.mesh.userData.fur, json.meshes[0].extras.fur);
  assert.ok(fur.coats.over.directionWeight >= 0 && fur.coats.under.directionWeight >= 0);
  vertices += fur.length.count;
  triangles += (fur.mesh.geometry.index ?? fur.length).count / 3;

  assert.equal(fur.coats.uvSet !== undefined, path.endsWith("_uvs.glb"), "the mirror in UV sets");
  if (fur.coats.uvSet !== undefined) {
    assert.equal(fur.coats.uvSet, 2);
    const names = ["uv2", "uv3", "texcoord_4"].map((name) => fur.mesh.geometry.attributes[name]);
    for (let v = 0; v < fur.length.count; ++v) {
      assert.deepEqual(
        [names[0].getX(v), names[0].getY(v), names[1].getX(v), names[1].getY(v), names[2].getX(v)],
        [fur.length.getX(v), fur.density.getX(v), d[3 * v], d[3 * v + 1], d[3 * v + 2]]);
    }
  }

  // The example of the README.
  const lines = furLines(fur);
  assert.equal(lines.geometry.attributes.position.count, 2 * fur.length.count);
  assert.ok(lines.geometry.attributes.position.array.every(Number.isFinite));
}
assert.equal(vertices, info.vertices);
assert.equal(triangles, info.triangles);
for (const name of Object.keys(all)) sameRange(name, extent(all[name]), info.fields[name]);
assert.equal(gltf.animations.length, json.animations?.length ?? 0);
const joints = furs.reduce((sum, { mesh }) => Math.max(sum, mesh.skeleton?.bones.length ?? 0), 0);
assert.equal(joints, json.skins?.[0].joints.length ?? 0);
console.log(`${path}: ${furs.length} meshes with fur, ${vertices} vertices, ${triangles} triangles, ` +
  `${joints} joints, ${gltf.animations.length} animations`);
