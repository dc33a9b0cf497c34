// One frame of three.js: camera depth and id of every pixel, as floats, into a page (three_render.py).
import * as THREE from './three.module.js';

const vertexShader = `
in vec3 position;
uniform mat4 modelViewMatrix, projectionMatrix;
out float depth;
flat out uint triangle;
void main() {
    vec4 p_camera = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * p_camera;
    depth = -p_camera.z;
    triangle = uint(gl_VertexID / 3);
}`;
const fragmentShader = `
precision highp float;
in float depth;
flat in highp uint triangle;
out vec4 frame;
void main() { frame = vec4(depth, float(triangle & 0xFFFFu), float(triangle >> 16), 1.0); }`;

/// `view` has width, height, and two matrices in columns; `corners` is a Float32Array.
export function render(view, corners) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(corners, 3));
    const material = new THREE.RawShaderMaterial({
        vertexShader, fragmentShader, glslVersion: THREE.GLSL3, side: THREE.DoubleSide, blending: THREE.NoBlending});
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    const scene = new THREE.Scene();
    scene.add(mesh);
    const camera = new THREE.Camera();
    camera.matrixAutoUpdate = camera.matrixWorldAutoUpdate = false;
    camera.matrixWorldInverse.fromArray(view.cameraFromWorld);
    camera.projectionMatrix.fromArray(view.clipFromCamera);
    const renderer = new THREE.WebGLRenderer();
    const gl = renderer.getContext();
    if (!gl.getExtension('EXT_color_buffer_float')) throw new Error('no float targets');
    const target = new THREE.WebGLRenderTarget(view.width, view.height, {
        type: THREE.FloatType, format: THREE.RGBAFormat, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
    renderer.setRenderTarget(target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(scene, camera);
    const frame = new Float32Array(4 * view.width * view.height);
    renderer.readRenderTargetPixels(target, 0, 0, view.width, view.height, frame);
    return frame;
}
