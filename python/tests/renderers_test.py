"""The examples that judge other renderers. They need python3-vtk9, xvfb, python3-open3d and cc."""
import pytest
from example_runs import example_says

SAYS = {
    "vtk_offscreen": [
        r"room, door: proven, 57,600 pixels",
        r"orthographic, isometric: proven, 57,600 pixels",
        r"likely cause: depth is NDC z \(0 to 1\) \(explains 100% .*",
    ],
    "open3d_raycasting": [
        r"room, door: proven, 57,600 pixels",
        r"near_plane, aside: proven, 57,600 pixels",
        r"likely cause: depth is the ray's length \(explains 100% .*",
    ],
}


@pytest.mark.parametrize("name", SAYS)
def test_example(name, tmp_path):
    example_says(name, SAYS[name], tmp_path)
