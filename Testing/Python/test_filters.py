"""Palpate's filters run from Python on NumPy arrays, in a pipeline with VTK's own filters."""

import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkTable
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties

import palpate
from palpate import vtkElasticSurface, vtkSegmentationSurface

SPACING = numpy.array([1.0, 1.5, 3.0])  # mm
ORIGIN = numpy.array([-40.0, 25.0, 110.0])  # mm, patient LPS
# A quarter turn about z, then one about x: columns are the index axes in the world.
DIRECTION = numpy.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
SHAPE = numpy.array([40, 30, 16])  # i, j, k


def image_of(array):
    """vtkImageData of an array indexed [i, j, k]."""
    image = vtkImageData()
    image.SetDimensions(*array.shape)
    image.SetSpacing(*SPACING)
    image.SetOrigin(*ORIGIN)
    image.SetDirectionMatrix(*DIRECTION.ravel())
    image.GetPointData().SetScalars(numpy_to_vtk(array.ravel(order="F"), deep=True))
    return image


def ellipsoid(center, axes, label):
    """Mask of an ellipsoid given in index coordinates."""
    grid = numpy.indices(SHAPE)
    distance = sum(((grid[n] - center[n]) / axes[n]) ** 2 for n in range(3))
    return numpy.where(distance <= 1.0, label, 0).astype(numpy.uint8)


class Package(unittest.TestCase):
    def test_star_import_has_filters_and_arrays(self):
        names = {}
        exec("from palpate import *", names)
        self.assertIn("vtkSegmentationSurface", names)
        self.assertIn("fit_mask", names)
        self.assertNotIn("importlib", names)

    def test_unknown_filter_is_no_attribute(self):
        self.assertFalse(hasattr(palpate, "vtkSegmentationSurfac"))
        self.assertIn("vtkSegmentationSurface", dir(palpate))


class SegmentationSurface(unittest.TestCase):
    center = numpy.array([21.0, 13.0, 8.0])

    def setUp(self):
        self.mask = ellipsoid(self.center, (12.0, 9.0, 5.0), 7)
        self.filter = vtkSegmentationSurface()
        self.filter.SetInputData(image_of(self.mask))
        self.filter.SetLabel(7)

    def test_output_is_closed(self):
        edges = vtkFeatureEdges()
        edges.SetInputConnection(self.filter.GetOutputPort())
        edges.FeatureEdgesOff()
        edges.BoundaryEdgesOn()
        edges.NonManifoldEdgesOn()
        edges.Update()
        self.assertGreater(self.filter.GetOutput().GetNumberOfPolys(), 100)
        self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)

    def test_output_encloses_mask_volume(self):
        mass = vtkMassProperties()
        mass.SetInputConnection(self.filter.GetOutputPort())
        mass.Update()
        voxels = numpy.count_nonzero(self.mask) * SPACING.prod()
        # The default keeps the mask's volume within 2 %.
        self.assertAlmostEqual(mass.GetVolume() / voxels, 1.0, delta=0.02)

    def test_output_follows_direction_matrix(self):
        self.filter.Update()
        points = vtk_to_numpy(self.filter.GetOutput().GetPoints().GetData())
        middle = (points.min(axis=0) + points.max(axis=0)) / 2.0
        expected = ORIGIN + DIRECTION @ (self.center * SPACING)
        # A symmetric body: its bounding box has the same centre, to a small fraction of a voxel.
        numpy.testing.assert_allclose(middle, expected, atol=0.2)

    def test_absent_label_raises_error_event(self):
        errors = []
        self.filter.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
        self.filter.GetExecutive().AddObserver("ErrorEvent", lambda caller, event: None)
        self.filter.SetLabel(3)
        self.filter.Update()
        self.assertEqual(errors, ["ErrorEvent"])
        self.assertEqual(self.filter.GetOutput().GetNumberOfPoints(), 0)


def sphere_model(radius, center):
    """A ball as a table of coefficients."""
    table = vtkTable()
    for name, value in (("Degree", 0.0), ("Order", 0.0), ("Coefficient", radius * (4.0 * numpy.pi) ** 0.5)):
        column = numpy_to_vtk(numpy.array([value]), deep=True)
        column.SetName(name)
        table.AddColumn(column)
    place = numpy_to_vtk(numpy.array([center]), deep=True)
    place.SetName("Center")
    table.GetFieldData().AddArray(place)
    return table


class ElasticSurface(unittest.TestCase):
    def setUp(self):
        self.filter = vtkElasticSurface()
        self.filter.SetInputData(sphere_model(25.0, (1.0, 2.0, 3.0)))
        self.filter.SetElementsAcross(4)
        self.filter.SetFrequency(8)

    def ball_force(self):
        self.filter.Update()
        force = self.filter.GetOutput().GetFieldData().GetArray("BallForce")
        return numpy.linalg.norm(vtk_to_numpy(force))

    def test_deeper_balls_are_pushed_harder(self):
        self.filter.SetBallDepth(1.0)
        shallow = self.ball_force()
        self.filter.SetBallDepth(2.0)
        self.assertGreater(shallow, 0.0)
        # Hertz: 2 to the power 1.5.
        self.assertGreater(self.ball_force(), 2.0 * shallow)

    def test_stiffer_tissue_has_larger_forces_everywhere(self):
        def forces(kilopascal):
            self.filter.SetTissueModulus(kilopascal)
            self.filter.Update()
            return vtk_to_numpy(self.filter.GetOutput().GetPointData().GetArray("Force")).copy()

        self.assertTrue((forces(40.0) > 1.3 * forces(20.0)).all())


if __name__ == "__main__":
    unittest.main()
