"""The projection matrix that OpenGL's programs have, z in [-1, 1], whatever the view's own is."""
import numpy as np


def projection(camera):
    """Rows, for column vectors: p_clip = projection(camera) @ p_camera."""
    left, right, bottom, top = (camera.window[key] for key in ('left', 'right', 'bottom', 'top'))
    near, far = camera.near, camera.far
    m = np.zeros((4, 4))
    m[0, 0], m[1, 1] = 2 / (right - left), 2 / (top - bottom)
    middle = m[0, 0] * (right + left) / 2, m[1, 1] * (top + bottom) / 2
    if camera.perspective:
        m[:2, 2], m[3, 2] = middle, -1
        m[2, 2:] = (-1, -2 * near) if far == np.inf else ((far + near) / (near - far), 2 * far * near / (near - far))
    else:
        m[:2, 3], m[3, 3] = np.negative(middle), 1
        m[:2, 2] = m[0, 0] * camera.shear[0], m[1, 1] * camera.shear[1]
        m[2, 2:] = 2 / (near - far), (far + near) / (near - far)
    return m
