#pragma once

#include "SceneRepresentation.h"
#include "StudyState.h"

#include "RandomShapes.h"

namespace palpate::test
{
inline bool RandomChoice(Random& random)
{
  return random() % 2 == 0;
}

inline double RandomNumber(Random& random, double least, double most)
{
  return std::uniform_real_distribution<double>(least, most)(random);
}

inline int RandomWhole(Random& random, int least, int most)
{
  return std::uniform_int_distribution<int>(least, most)(random);
}

inline Vector3 RandomPlace(Random& random)
{
  return 200.0 * RandomDirection(random);
}

/// A name with characters that files and JSON must quote.
inline std::string RandomName(Random& random)
{
  const std::vector<std::string> parts{"Prostata", " \"", "\\", "\xC3\xA4", "\n", "\t", ",", "7"};
  std::string name;
  for (int i = RandomWhole(random, 0, 4); i > 0; --i)
  {
    name += parts[random() % parts.size()];
  }
  return name;
}

inline SceneStructure RandomStructure(Random& random)
{
  SceneStructure structure;
  structure.Id = RandomWhole(random, 1, 300);
  structure.Labels = {std::to_string(structure.Id)};
  structure.File = StudyPath("masks/1.seg.nrrd");
  structure.Name = RandomName(random);
  structure.Color = {{RandomNumber(random, 0.0, 1.0), RandomNumber(random, 0.0, 1.0), 1.0}};
  structure.Opacity = RandomChoice(random) ? 1.0 : RandomNumber(random, 0.0, 1.0);
  structure.IsVisible = RandomChoice(random);
  structure.IsTouchable = RandomChoice(random);
  structure.Appearance = static_cast<SceneAppearance>(RandomWhole(random, 0, 5));
  structure.Representation =
      SceneRepresentations().at(static_cast<std::size_t>(RandomWhole(random, 0, 5))).Name;
  structure.Degree = RandomWhole(random, 0, 40);
  structure.Mode = static_cast<RadialContactMode>(RandomWhole(random, 0, 1));
  structure.Interpolation = static_cast<FieldInterpolation>(RandomWhole(random, 0, 1));
  structure.Smoothing = RandomNumber(random, 0.0, 4.0);
  structure.Stiffness = RandomNumber(random, 0.0, 3.0);
  structure.Damping = RandomNumber(random, 0.0, 0.1);
  structure.SetNumber("viscosity_ns_per_mm", RandomNumber(random, 0.0, 0.1));
  structure.SetNumber("texture_n", RandomChoice(random) ? 0.0 : RandomNumber(random, 0.0, 1.0));
  structure.SetImage("texture_image",
                     RandomChoice(random) ? "" : StudyPath("volumes/t2 \xC3\xA4.nii.gz"));
  structure.SetNumber("stiffness_from_value", RandomNumber(random, -1000.0, 1000.0));
  structure.SetImage("stiffness_image", RandomChoice(random) ? "" : StudyPath("adc.nii.gz"));
  structure.SetNumber("modulus_kpa", RandomNumber(random, 1.0, 100.0));
  structure.SetNumber("free_side", RandomWhole(random, 0, 6));
  structure.SetNumber("elements_across", 2 * RandomWhole(random, 0, 12));
  structure.SetNumber("inclusion_kpa", RandomChoice(random) ? 0.0 : 60.5);
  structure.SetImage("elastography_image", RandomChoice(random) ? "" : StudyPath("mre.nii.gz"));
  structure.Drill = {RandomNumber(random, 0.0, 1.0), 0.001, 0.5};
  structure.IsForbidden = RandomChoice(random);
  structure.AlarmDistance = RandomNumber(random, 0.0, 5.0);
  if (RandomWhole(random, 0, 3) == 0)
  {
    structure.Labels.clear();
    structure.Iso = RandomNumber(random, -100.0, 100.0);
    structure.Series = RandomChoice(random) ? "" : "2";
    if (RandomChoice(random))
    {
      structure.IsoUpper = *structure.Iso + RandomNumber(random, 1.0, 100.0);
      structure.WithinFile = StudyPath("masks/skull.nii.gz");
      structure.WithinLabel = "temporal bone";
    }
  }
  structure.Friction = {RandomNumber(random, 0.5, 1.0), RandomNumber(random, 0.0, 0.5)};
  return structure;
}

inline void RandomizeFit(Random& random, FitSettings& fit)
{
  fit.Rules = RandomWhole(random, 1, 2);
  fit.Method = static_cast<FitSettings::SurfaceMethod>(RandomWhole(random, 0, 1));
  fit.Smoothing = RandomNumber(random, 0.0, 3.0);
  fit.Component = RandomWhole(random, 0, 3);
  fit.IsAlone = RandomChoice(random);
  fit.Frequency = RandomWhole(random, 1, 60);
  fit.Center = static_cast<FitSettings::CenterChoice>(RandomWhole(random, 0, 1));
  if (RandomChoice(random))
  {
    const Vector3 center = RandomPlace(random);
    fit.GivenCenterWorld = {center[0], center[1], center[2]};
  }
  fit.Degree = RandomWhole(random, 0, 40);
  if (RandomChoice(random))
  {
    fit.Tolerance = RandomNumber(random, 0.0, 1.0);
  }
  fit.MaximumDegree = RandomWhole(random, 0, 60);
  fit.Weight = static_cast<FitSettings::SampleWeight>(RandomWhole(random, 0, 2));
  fit.PenaltyKind = static_cast<FitSettings::Penalty>(RandomWhole(random, 0, 2));
  fit.Roughness = RandomNumber(random, 0.0, 1e-3);
  fit.Model = static_cast<FitSettings::ModelKind>(RandomWhole(random, 0, 2));
  fit.Repairs = RandomWhole(random, 0, 1) == 1;
  fit.IsRobust = RandomWhole(random, 0, 1) == 1;
  fit.MaximumHiddenPercent = RandomNumber(random, 0.0, 100.0);
  fit.MinimumDice = RandomNumber(random, 0.0, 1.0);
}

inline void RandomizeTouch(Random& random, StudyState& state)
{
  if (RandomChoice(random))
  {
    state.Guides = {{GuideShape::Point, {Vector3::Constant(RandomNumber(random, -90.0, 90.0))}}};
    GuideSettings level;
    level.Shape = static_cast<GuideShape>(RandomWhole(random, 3, 5));
    level.Structure = RandomWhole(random, 1, 99);
    level.Distance = RandomNumber(random, -9.0, 9.0);
    state.Guides.push_back(level);
  }
  state.Tool.Kind = static_cast<TouchToolSettings::Shape>(RandomWhole(random, 0, 2));
  state.Tool.Radius = RandomNumber(random, 0.0, 5.0);
  state.Tool.Length = RandomNumber(random, 1.0, 20.0);
  state.Tool.SemiAxes = Vector3::Constant(RandomNumber(random, 1.0, 5.0));
  state.Tool.Points = RandomWhole(random, 0, 100);
  state.Device = RandomName(random);
  state.Rate = RandomNumber(random, 1.0, 5000.0);
  state.Placement = {};
  if (RandomChoice(random))
  {
    state.Placement.Scale = RandomNumber(random, 0.1, 10.0);
    state.Placement.CenterWorld = RandomPlace(random);
  }
  state.Placement.AxesFollowCamera = RandomChoice(random);
}

inline StudyView RandomView(Random& random)
{
  StudyView view;
  if (RandomChoice(random))
  {
    view.CrosshairWorld = RandomPlace(random);
    view.Window = RandomNumber(random, 0.0, 4000.0);
    view.Level = RandomNumber(random, -1000.0, 1000.0);
  }
  view.Layout = RandomName(random);
  view.OverlayOpacity = RandomNumber(random, 0.0, 1.0);
  view.UsesVolumeAxes = RandomChoice(random);
  view.SlicesFollowProbe = RandomChoice(random);
  view.Mixing = static_cast<StudyMixing>(RandomWhole(random, 0, 2));
  view.Curtain = RandomNumber(random, 0.0, 1.0);
  if (RandomChoice(random))
  {
    view.ErrorScale = RandomNumber(random, 0.1, 10.0);
  }
  return view;
}

inline StudyRendering RandomRendering(Random& random)
{
  return {RandomChoice(random), static_cast<VolumePreset>(RandomWhole(random, 0, 3))};
}

inline StudyVolume RandomVolume(Random& random, int id)
{
  StudyVolume volume;
  volume.Id = id;
  volume.File = StudyPath("volumes/" + std::to_string(id) + ".nrrd");
  volume.Series = RandomChoice(random) ? "" : "1.2.3." + std::to_string(id);
  volume.Transform = RandomChoice(random) ? "" : StudyPath("volumes/moved.tfm");
  volume.IsVisible = RandomChoice(random);
  if (RandomChoice(random))
  {
    volume.Window = RandomNumber(random, 1.0, 2000.0);
    volume.Level = RandomNumber(random, -1000.0, 1000.0);
  }
  volume.Colors = AllVolumeColors.at(static_cast<std::size_t>(RandomWhole(random, 0, 5)));
  volume.Opacity = RandomNumber(random, 0.0, 1.0);
  volume.HidesBelow = RandomChoice(random);
  volume.Rendering = RandomRendering(random);
  return volume;
}

inline StudyMeasurement RandomMeasurement(Random& random)
{
  StudyMeasurement measurement;
  measurement.Kind = static_cast<MeasurementKind>(RandomWhole(random, 0, MeasurementKindCount - 1));
  measurement.Name = RandomName(random);
  const std::size_t count = PointCountOf(measurement.Kind);
  for (std::size_t i = 0; i < (count == 0 ? 5 : count); ++i)
  {
    measurement.PointsWorld.push_back(RandomPlace(random));
  }
  if (measurement.Kind == MeasurementKind::SurfaceCurve)
  {
    measurement.PathLength = 12.5;
    measurement.PathWorld = {RandomPlace(random), RandomPlace(random)};
    measurement.StructureId = RandomWhole(random, 1, 100);
  }
  return measurement;
}

/// Most entries differ from their defaults.
inline StudyDrawing RandomDrawing(Random& random)
{
  StudyDrawing drawing;
  drawing.PriorFile = RandomChoice(random) ? "" : StudyPath("../prior.json");
  drawing.Sigma = RandomNumber(random, 0.1, 3.0);
  drawing.IsTouchable = RandomChoice(random);
  if (RandomChoice(random))
  {
    drawing.CenterWorld = RandomPlace(random);
  }
  for (int i = RandomWhole(random, 0, 5); i > 0; --i)
  {
    SurfaceTouch touch{RandomPlace(random), RandomNumber(random, 0.1, 3.0)};
    if (RandomChoice(random))
    {
      touch.Normal = RandomPlace(random).normalized();
    }
    touch.Stroke = RandomWhole(random, 0, 3);
    touch.IsOutside = RandomChoice(random);
    drawing.Touches.push_back(touch);
  }
  return drawing;
}

/// Steps of all kinds.
inline StudyCorrection RandomCorrection(Random& random)
{
  StudyCorrection correction;
  correction.StructureId = RandomWhole(random, 0, 300);
  correction.Neighbors = static_cast<NeighborPolicy>(RandomWhole(random, 0, 2));
  for (int i = RandomWhole(random, 0, 5); i > 0; --i)
  {
    SurfacePull pull;
    pull.PlaceWorld = RandomPlace(random);
    pull.Width = RandomNumber(random, 1.0, 20.0);
    pull.SecondWidth = RandomChoice(random) ? 0.0 : RandomNumber(random, 1.0, 20.0);
    if (RandomChoice(random))
    {
      pull.TargetWorld = RandomPlace(random);
    }
    else
    {
      pull.Displacement = RandomNumber(random, -9.0, 9.0);
    }
    BrushStroke stroke;
    stroke.PointsWorld = std::make_shared<const BrushStroke::Path>(
        BrushStroke::Path{RandomPlace(random), RandomPlace(random)});
    stroke.Erases = RandomChoice(random);
    stroke.SliceNormal = RandomChoice(random) ? std::nullopt : std::optional(RandomPlace(random));
    const IndexRun run{{RandomWhole(random, 0, 9), 2, 3}, 4};
    const std::array<CorrectionStep, 9> steps{
        {pull, IslandRemoval{}, CavityFilling{}, SurfaceSmoothing{RandomNumber(random, 0.5, 3.0)},
         PlaneCut{RandomPlace(random), RandomPlace(random)}, stroke,
         VoxelEdit{std::make_shared<const std::vector<IndexRun>>(2, run), RandomChoice(random)},
         SliceCopy{RandomWhole(random, 0, 2), 3, 4},
         SliceFilling{RandomWhole(random, 0, 2), 3, 9}}};
    correction.Steps.push_back(steps[random() % steps.size()]);
  }
  return correction;
}

inline StudyState RandomStudy(Random& random)
{
  StudyState state;
  state.VolumeFile = StudyPath("volumes/t2 \xC3\xA4.nii.gz");
  state.SegmentationFile = RandomChoice(random) ? "" : StudyPath("../masks/1.seg.nrrd");
  state.DicomSeries = RandomChoice(random) ? "" : "1.2.3";
  state.Rendering = RandomRendering(random);
  state.LeftHanded = static_cast<LeftHandedAxes>(RandomWhole(random, 0, 1));
  for (int i = RandomWhole(random, 0, 4); i > 0; --i)
  {
    state.Structures.push_back(RandomStructure(random));
    state.Landmarks.push_back({RandomName(random), RandomPlace(random)});
    state.Measurements.push_back(RandomMeasurement(random));
    state.Volumes.push_back(RandomVolume(random, 3 * i));
  }
  if (!state.Measurements.empty() && RandomChoice(random))
  {
    state.Measurements.front().IsOpen = true;
    state.Measurements.front().PointsWorld.resize(1);
  }
  state.Drawing = RandomDrawing(random);
  state.Correction = RandomCorrection(random);
  RandomizeFit(random, state.Fit);
  RandomizeTouch(random, state);
  state.View = RandomView(random);
  return state;
}
} // namespace palpate::test
