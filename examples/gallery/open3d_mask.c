/* Open3D 0.16 asks Embree with the ray mask 0. Debian's Embree heeds masks, so that every ray misses everything
 * (docs/gallery.md). With this library, rays meet all geometry:
 *
 *     cc -shared -fPIC -o open3d_mask.so open3d_mask.c
 *     LD_PRELOAD=./open3d_mask.so python3 open3d_render.py ...
 */
#include <dlfcn.h>
#include <embree3/rtcore.h>

void rtcIntersect1M(RTCScene scene, struct RTCIntersectContext* context, struct RTCRayHit* hits,
                    unsigned int count, size_t stride) {
    void (*embree)(RTCScene, struct RTCIntersectContext*, struct RTCRayHit*, unsigned int, size_t) =
        dlsym(dlopen("libembree3.so.3", RTLD_LAZY), "rtcIntersect1M");
    for (unsigned int i = 0; i < count; ++i)
        ((struct RTCRayHit*)((char*)hits + i * stride))->ray.mask = 0xFFFFFFFF;
    embree(scene, context, hits, count, stride);
}
