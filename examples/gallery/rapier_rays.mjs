// Rapier's rays before the judge (docs/gallery.md); from npm @dimforge/rapier3d-compat. node_rays.py starts it.
import { answer, load } from './rays.mjs';

const rapier = load('@dimforge/rapier3d-compat');
await rapier.init();

answer((corners, reach) => {
  const vector = ([x, y, z]) => ({ x, y, z });
  const count = corners.length / 9, indices = Uint32Array.from({ length: 3 * count }, (_, i) => i);
  const world = new rapier.World(vector([0, 0, 0]));
  const mesh = world.createCollider(rapier.ColliderDesc.trimesh(corners, indices));
  return (origin, direction) => {
    const hit = mesh.castRayAndGetNormal(new rapier.Ray(vector(origin), vector(direction)), reach, false);
    return hit && [hit.featureId % count, hit.timeOfImpact];  // the back of triangle i is count + i
  };
});
