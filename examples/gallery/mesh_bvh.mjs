// three-mesh-bvh before the judge (docs/gallery.md); from npm three and three-mesh-bvh. node_rays.py starts it.
import { answer, load } from './rays.mjs';

const { BufferAttribute, BufferGeometry, DoubleSide, Ray } = load('three');
const { MeshBVH } = load('three-mesh-bvh');

answer((corners) => {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  const bvh = new MeshBVH(geometry, { indirect: true });
  const ray = new Ray();
  return (origin, direction) => {
    ray.origin.fromArray(origin);
    ray.direction.fromArray(direction);
    const hit = bvh.raycastFirst(ray, DoubleSide);
    return hit && [hit.faceIndex, hit.distance / ray.direction.length()];
  };
});
