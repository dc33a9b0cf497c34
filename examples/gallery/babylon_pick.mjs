// Babylon.js's picking before the judge (docs/gallery.md); from npm @babylonjs/core. node_rays.py starts it.
import { answer, load_module } from './rays.mjs';

const { Mesh, NullEngine, Ray, Scene, Vector3, VertexData } = await load_module('@babylonjs/core');

answer((corners) => {
  const scene = new Scene(new NullEngine());
  const data = new VertexData();
  data.positions = corners;
  data.indices = Uint32Array.from({ length: corners.length / 3 }, (_, i) => i);
  data.applyToMesh(new Mesh('scene', scene));
  return (origin, direction) => {
    const along = new Vector3(...direction), length = along.length();
    const hit = scene.pickWithRay(new Ray(new Vector3(...origin), along.normalize()));
    return hit.hit ? [hit.faceId, hit.distance / length] : null;
  };
});
