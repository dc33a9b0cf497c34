// three.js's Raycaster before the judge (docs/gallery.md); from npm three. node_rays.py starts it.
import { answer, load } from './rays.mjs';

const { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial, Raycaster, Vector3 } = load('three');

answer((corners) => {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  const mesh = new Mesh(geometry, new MeshBasicMaterial({ side: DoubleSide }));
  const raycaster = new Raycaster();
  return (origin, direction) => {
    const along = new Vector3(...direction), length = along.length();
    raycaster.set(new Vector3(...origin), along.normalize());
    const [hit] = raycaster.intersectObject(mesh);
    return hit && [hit.faceIndex, hit.distance / length];
  };
});
