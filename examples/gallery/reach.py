"""How far the rays of an adapter must reach."""
import numpy as np


def end_of_rays(corners, camera):
    """The camera depth beyond which no corner lies, at most far. Where it is not above near, nothing is seen."""
    return min(camera.far, 1.001 * np.max((corners - camera.eye) @ -np.array(camera.back), initial=-np.inf))
