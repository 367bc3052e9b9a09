"""What queries take."""

from typing import NamedTuple, Optional

from numpy.typing import ArrayLike


class Mask(NamedTuple):
    """A mask on a grid of its own, for comparisons of masks on different grids."""

    values: ArrayLike
    """(i, j, k): inside where not 0."""
    spacing: Optional[ArrayLike] = None
    """(3,), mm."""
    origin: Optional[ArrayLike] = None
    """(3,), mm, of the centre of voxel 0, 0, 0."""
    direction: Optional[ArrayLike] = None
    """(3, 3), whose columns are the axes."""
    affine: Optional[ArrayLike] = None
    """(4, 4) instead, from index to mm in patient LPS."""
