// three_example.mjs -- what a groomed .glb is in three.js, and one line for each vertex to show it.
//
//   const gltf = await new GLTFLoader().loadAsync("animal.glb");
//   for (const fur of furOf(gltf.scene)) fur.mesh.add(furLines(fur));
import * as THREE from "three";

// The fur of every mesh below `root`. three.js writes attribute names in lower case and keeps
// extras in userData.
export function furOf(root) {
  const furs = [];
  root.traverse((mesh) => {
    const fields = mesh.geometry?.attributes;
    if (!fields?._fur_length) return;
    furs.push({
      mesh,
      length: fields._fur_length, // one float for each vertex, in the units of the mesh
      density: fields._fur_density, // share of the hairs that grow, 0 to 1
      direction: fields._fur_direction, // axes of the mesh; 0 = along the normal, at most 1 long
      coats: mesh.userData.fur ?? mesh.parent?.userData.fur, // schema: assets/fur.schema.json
    });
  });
  return furs;
}

// Where a hair of the overcoat points that nothing bends: between the normal and the painted
// direction.
function hairDirection(normal, painted, weight) {
  return normal.clone().multiplyScalar(1 - weight).addScaledVector(painted, weight).normalize();
}

// A line from each vertex to where its hair would end, as a child for the mesh.
export function furLines({ mesh, length, direction, coats }) {
  const geometry = mesh.geometry;
  if (!geometry.attributes.normal) geometry.computeVertexNormals();
  const points = [];
  const normal = new THREE.Vector3();
  const painted = new THREE.Vector3();
  for (let v = 0; v < length.count; ++v) {
    const root = mesh.getVertexPosition(v, new THREE.Vector3());
    normal.fromBufferAttribute(geometry.attributes.normal, v);
    painted.fromBufferAttribute(direction, v);
    const along = hairDirection(normal, painted, coats.over.directionWeight);
    points.push(root, root.clone().addScaledVector(along, length.getX(v)));
  }
  const color = new THREE.Color(...coats.over.tipColor); // linear, as three.js works
  return new THREE.LineSegments(
    new THREE.BufferGeometry().setFromPoints(points),
    new THREE.LineBasicMaterial({ color }),
  );
}
