// Jolt's rays before the judge (docs/gallery.md); from npm jolt-physics. node_rays.py starts it.
import { answer, load_module } from './rays.mjs';

const jolt = await (await load_module('jolt-physics/wasm-compat')).default();

const vector = ([x, y, z]) => new jolt.Vec3(x, y, z);

/// A world of one layer, in which one body stands.
function world_of(shape) {
  const settings = new jolt.JoltSettings();
  settings.mObjectLayerPairFilter = new jolt.ObjectLayerPairFilterTable(1);
  const layers = settings.mBroadPhaseLayerInterface = new jolt.BroadPhaseLayerInterfaceTable(1, 1);
  layers.MapObjectToBroadPhaseLayer(0, new jolt.BroadPhaseLayer(0));
  settings.mObjectVsBroadPhaseLayerFilter =
    new jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, settings.mObjectLayerPairFilter, 1);
  const world = new jolt.JoltInterface(settings), bodies = world.GetPhysicsSystem().GetBodyInterface();
  const body = new jolt.BodyCreationSettings(shape, new jolt.RVec3(0, 0, 0), new jolt.Quat(0, 0, 0, 1),
    jolt.EMotionType_Static, 0);
  bodies.CreateAndAddBody(body, jolt.EActivation_DontActivate);
  return world.GetPhysicsSystem().GetNarrowPhaseQuery();
}

answer((corners, reach) => {
  const triangles = new jolt.TriangleList();
  for (let i = 0; i < corners.length / 9; ++i) {
    const [a, b, c] = [0, 3, 6].map((j) => vector(corners.subarray(9 * i + j, 9 * i + j + 3)));
    triangles.push_back(new jolt.Triangle(a, b, c, 0, i));
  }
  const settings = new jolt.MeshShapeSettings(triangles, new jolt.PhysicsMaterialList());
  settings.mPerTriangleUserData = true;
  const shape = settings.Create().Get(), mesh = jolt.castObject(shape, jolt.MeshShape);
  const query = world_of(shape);
  const sides = new jolt.RayCastSettings(), nearest = new jolt.CastRayClosestHitCollisionCollector();
  sides.SetBackFaceMode(jolt.EBackFaceMode_CollideWithBackFaces);
  const all = [new jolt.BroadPhaseLayerFilter(), new jolt.ObjectLayerFilter(), new jolt.BodyFilter(), new jolt.ShapeFilter()];
  const ray = new jolt.RRayCast();
  return (origin, direction) => {
    ray.mOrigin.Set(...origin);
    ray.mDirection.Set(...direction.map((d) => d * reach));
    nearest.Reset();
    query.CastRay(ray, sides, nearest, ...all);
    if (!nearest.HadHit()) return null;
    return [mesh.GetTriangleUserData(nearest.mHit.mSubShapeID2), reach * nearest.mHit.mFraction];
  };
});
