"""Drives the plugin by pvpython: reads an atlas, fits a structure, maps errors, draws, and checks each result.

pvpython drive.py PLUGIN TEMPLATES MODEL OUTPUT: Palpate.so, the folder of Debian's mricron-data, a model file, and the folder for pictures.
"""

import pathlib
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

THALAMUS = 77
WHITE = [1.0, 1.0, 1.0]
RED = [0.8, 0.1, 0.1]
SIZE = [500, 500]


def check(is_right, fact):
    print(("right: " if is_right else "WRONG: ") + fact)
    if not is_right:
        sys.exit(1)


def field_value(proxy, name):
    data = servermanager.Fetch(proxy)
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def render_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = WHITE
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    return view


def look_from_left(view, bounds):
    """Looks along -x at the centre of bounds; the view is 1.25 times as high as they are. Returns mm per pixel."""
    middle = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2]
    height = 1.25 * max(bounds[3] - bounds[2], bounds[5] - bounds[4])
    view.CameraFocalPoint = middle
    view.CameraPosition = [middle[0] + 400, middle[1], middle[2]]
    view.CameraViewUp = [0, 0, 1]
    view.CameraParallelScale = height / 2
    return height / SIZE[1]  # mm per pixel


def picture(view, path):
    simple.Render(view)
    simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    colors = vtk_to_numpy(image.GetPointData().GetScalars())
    return colors.reshape(image.GetDimensions()[1], image.GetDimensions()[0], -1)[:, :, :3].astype(int)


def drawn(pixels):
    """Where a picture is not white."""
    return (pixels < 240).any(axis=2)


def extent_of(mask):
    rows, columns = numpy.nonzero(mask)
    return columns.max() - columns.min() + 1, rows.max() - rows.min() + 1


def fit_structure(atlas):
    fit = simple.PalpateFit(Input=atlas, Label=THALAMUS, Model="Surface", Degree=12)
    fit.UpdatePipeline()
    dice = field_value(fit, "Dice")
    check(dice > 0.9, f"the model's Dice is {dice:.3f}")
    mean = field_value(fit, "MeanDistance")
    check(0.0 < mean < 0.5, f"the model is {mean:.3f} mm from the mask's boundary in the mean")
    return fit


def map_errors(atlas, fit):
    surface = simple.PalpateStructureSurface(Input=atlas, Label=THALAMUS)
    errors = simple.PalpateSurfaceErrors(Input=fit, Reference=surface)
    errors.UpdatePipeline()
    errors.UpdatePropertyInformation()
    mean = errors.GetProperty("MeanDistance").GetElement(0)
    largest = errors.PointData["Distance"].GetRange()[1]
    check(0.0 < mean < largest < 10.0, f"errors: mean {mean:.3f} mm, at most {largest:.2f} mm")
    return surface, errors


def fit_step_by_step(surface):
    samples = simple.PalpateRadialSamples(Input=surface, Directions=simple.PalpateDirections())
    table = simple.PalpateRadialModel(Input=samples, Degree=6)
    model = simple.PalpateModelSurface(Input=table, Original=surface)
    model.UpdatePipeline()
    low, high = model.PointData["DistanceToSurface"].GetRange()
    check(low < 0.0 < high, f"the radial model runs from {low:.2f} to {high:.2f} mm from the surface")
    soft = simple.PalpateElasticSurface(Input=table, BallDepth=2.0)
    soft.UpdatePipeline()
    force = numpy.linalg.norm(servermanager.Fetch(soft).GetFieldData().GetArray("BallForce").GetTuple(0))
    check(0.05 < force < 20.0, f"a ball that is 2 mm deep feels {force:.2f} N")


def draw_model(fit, output):
    """The fitted surface alone: its place and colours in the picture."""
    view = render_view()
    display = simple.Show(fit, view)
    simple.ColorBy(display, ("POINTS", "DistanceToSurface"))
    simple.GetColorTransferFunction("DistanceToSurface").RescaleTransferFunction(-1.0, 1.0)
    bounds = fit.GetDataInformation().GetBounds()
    pixel = look_from_left(view, bounds)
    pixels = picture(view, output / "model.png")
    seen = drawn(pixels)
    width, height = extent_of(seen)
    wanted = ((bounds[3] - bounds[2]) / pixel, (bounds[5] - bounds[4]) / pixel)
    check(abs(width - wanted[0]) <= 3 and abs(height - wanted[1]) <= 3,
          f"the model covers {width} x {height} pixels, and should {wanted[0]:.0f} x {wanted[1]:.0f}")
    colors = pixels[seen]
    check((colors[:, 0] > colors[:, 2] + 40).any() and (colors[:, 2] > colors[:, 0] + 40).any(),
          "it is blue where it lies inside the structure and red outside")
    return seen, bounds


def draw_sub_voxel(atlas, model_seen, bounds, output):
    """The structure's voxels as a sub-voxel surface, which has the fitted model's outline."""
    inside = simple.Calculator(Input=atlas, ResultArrayName="inside", Function=f"{atlas.PointData.GetArray(0).Name} == {THALAMUS}")
    view = render_view()
    display = simple.Show(inside, view)
    display.SetRepresentationType("Sub-voxel surface")
    display.SubVoxelValue = 0.5
    display.SubVoxelColor = RED
    look_from_left(view, bounds)
    pixels = picture(view, output / "sub-voxel.png")
    seen = drawn(pixels)
    red = pixels[seen].mean(axis=0)
    check(red[0] > 2 * red[1] and red[0] > 2 * red[2], f"the sub-voxel surface is red: {red.round()}")
    overlap = 2.0 * (seen & model_seen).sum() / (seen.sum() + model_seen.sum())
    check(overlap > 0.95, f"the outlines of voxels and model overlap by {overlap:.3f}")
    return inside


def draw_together(fit, templates, output):
    """The fitted structure in a translucent head."""
    head = simple.PalpateVolume(FileName=str(templates / "ch2bet.nii.gz"))
    head.UpdatePipeline()
    view = render_view()
    display = simple.Show(head, view)
    display.SetRepresentationType("Sub-voxel surface")
    display.SubVoxelValue = 60.0
    look_from_left(view, head.GetDataInformation().GetBounds())
    head_alone = picture(view, output / "head.png")
    check(drawn(head_alone).mean() > 0.2, "the head's surface fills a part of its picture")
    check(head_alone[drawn(head_alone)].std() > 10.0, "and is shaded")
    display.SubVoxelOpacity = 0.4
    shown = simple.Show(fit, view)
    shown.ColorArrayName = ["POINTS", ""]  # ColorBy(shown, None) fails in ParaView 5.11
    shown.DiffuseColor = RED
    together = picture(view, output / "together.png")
    reddish = together[:, :, 0] > together[:, :, 1] + 40
    check(500 < reddish.sum() < 50000, f"the fitted structure is seen through it, on {reddish.sum()} pixels")


def main():
    plugin, templates, model, output = (pathlib.Path(given) for given in sys.argv[1:])
    simple._DisableFirstRenderCameraReset()
    simple.LoadPlugin(str(plugin), remote=False, ns=vars(simple))
    atlas = simple.PalpateSegmentation(FileName=str(templates / "aal.nii.gz"))
    atlas.UpdatePipeline()
    check(atlas.PointData.GetArray(0).GetRange() == (0.0, 116.0), "the atlas has labels up to 116")
    fit = fit_structure(atlas)
    surface, _ = map_errors(atlas, fit)
    fit_step_by_step(surface)
    read = simple.OpenDataFile(str(model))
    read.UpdatePipeline()
    check(read.GetDataInformation().GetNumberOfPoints() > 1000, "a model file opens by its ending")
    model_seen, bounds = draw_model(fit, output)
    draw_sub_voxel(atlas, model_seen, bounds, output)
    draw_together(fit, templates, output)


main()
