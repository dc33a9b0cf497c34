// Which of two triangles does Rapier's ray hit? (docs/found.md); from npm @dimforge/rapier3d-compat.
const rapier = require('@dimforge/rapier3d-compat');

rapier.init().then(() => {
  const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 3, 0, 0, 2, 1, 0];
  const mesh = new rapier.World({ x: 0, y: 0, z: 0 }).createCollider(
    rapier.ColliderDesc.trimesh(new Float32Array(corners), new Uint32Array([0, 1, 2, 3, 4, 5])));
  const face = (z) => mesh.castRayAndGetNormal(
    new rapier.Ray({ x: 2.2, y: 0.2, z }, { x: 0, y: 0, z: -z }), 9, false).featureId;
  console.log(`triangle 1, front: ${face(1)}, back: ${face(-1)}; right is: 1, 3`);
});
