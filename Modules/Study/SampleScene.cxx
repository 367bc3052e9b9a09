#include "SampleScene.h"

#include "ImageWriter.h"
#include "InputError.h"
#include "MastoidPhantom.h"
#include "OutputFolder.h"
#include "PhantomSampler.h"
#include "ProstateLikeModel.h"
#include "SegmentationFile.h"
#include "StudyStructures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <system_error>

namespace palpate
{
namespace
{
constexpr int Degree = 12; // of the prostate-like body, as `palpate phantom` makes it
constexpr std::uint64_t Seed = 1;
constexpr double Margin = 10.0; // mm, from the body to the sides of its images

bool AreThere(const std::vector<std::filesystem::path>& files)
{
  std::error_code failure;
  return std::all_of(files.begin(), files.end(),
                     [&failure](const std::filesystem::path& file)
                     { return std::filesystem::exists(file, failure); });
}

PhantomGrid GridAround(const RadialModel& body, const Vector3& spacing)
{
  PhantomGrid grid;
  grid.Spacing = spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = 2.0 * (PhantomSampler::RadiusBound(body) + Margin);
    grid.Size.at(static_cast<std::size_t>(axis)) =
        static_cast<int>(std::ceil(side / grid.Spacing[axis]));
  }
  grid.CenterOn(body.CenterWorld());
  return grid;
}

// Volume and mask, and the nodule's mask if `look` has one.
void MakeBody(const std::filesystem::path& folder, const PhantomAppearance& look,
              const ProgressFunction& progress)
{
  const RadialModel body = MakeProstateLikeModel(Degree, Seed, Vector3::Zero());
  const PhantomImages made = MakePhantom(body, GridAround(body, {0.8, 0.8, 1.5}), look,
                                         [&progress](double part)
                                         { ReportProgress(progress, part, "making the images"); });
  MakeOutputFolder(folder);
  WriteImage(folder / "volume.nii.gz", made.Volume);
  WriteImage(folder / "mask.nii.gz", made.Mask);
  if (made.Nodule != nullptr)
  {
    WriteImage(folder / "nodule.nii.gz", made.Nodule);
  }
}

PhantomAppearance LookOfMr()
{
  PhantomAppearance look;
  look.NoiseDeviation = 10.0;
  look.BiasAmplitude = 0.15;
  look.Seed = Seed;
  return look;
}

SceneStructure LabelOf(const std::filesystem::path& file, int label, int id,
                       const std::string& name)
{
  SceneStructure structure;
  structure.Id = id;
  structure.Name = name;
  structure.File = file;
  structure.Labels = {std::to_string(label)};
  structure.Representation = TouchRepresentation::ModelOrField;
  return structure;
}

StudyState Prostate(const std::filesystem::path& folder, const ProgressFunction& progress)
{
  StudyState state;
  state.VolumeFile = folder / "volume.nii.gz";
  state.SegmentationFile = folder / "mask.nii.gz";
  if (!AreThere({state.VolumeFile, state.SegmentationFile}))
  {
    MakeBody(folder, LookOfMr(), progress);
  }
  state.Structures = {LabelOf(state.SegmentationFile, 1, 1, "Prostate")};
  return state;
}

// As in the tutorial: 20 kPa, a nodule of 10 mm and 80 kPa under the side that a finger reaches.
StudyState Lesion(const std::filesystem::path& folder, const ProgressFunction& progress)
{
  StudyState state;
  state.VolumeFile = folder / "volume.nii.gz";
  state.SegmentationFile = folder / "mask.nii.gz";
  const std::filesystem::path nodule = folder / "nodule.nii.gz";
  if (!AreThere({state.VolumeFile, state.SegmentationFile, nodule}))
  {
    PhantomAppearance look = LookOfMr();
    look.Nodule.emplace();
    const RadialModel body = MakeProstateLikeModel(Degree, Seed, Vector3::Zero());
    const Status placed = PhantomNodule::Place(body, 10.0, 2.0, *look.Nodule);
    if (!placed.IsOk())
    {
      throw InputError(placed.Message());
    }
    MakeBody(folder, look, progress);
  }
  SceneStructure gland = LabelOf(state.SegmentationFile, 1, 1, "Prostate");
  gland.Representation = TouchRepresentation::Elastic;
  gland.SetNumber("modulus_kpa", 20.0);
  gland.SetNumber("free_side", 3.0); // posterior
  gland.SetNumber("elements_across", 12.0);
  SceneStructure lesion = LabelOf(nodule, 1, 2, "Lesion");
  lesion.SetNumber("inclusion_kpa", 80.0);
  lesion.IsTouchable = false;
  lesion.Color = {{0.85, 0.2, 0.2}};
  state.Structures = {gland, lesion};
  state.Tool.Radius = 8.0; // about a finger's
  return state;
}

StudyState Mastoid(const std::filesystem::path& folder, const ProgressFunction& progress)
{
  StudyState state;
  state.VolumeFile = folder / "ct.nii.gz";
  state.SegmentationFile = folder / "structures.nii.gz";
  if (!AreThere({state.VolumeFile, state.SegmentationFile}))
  {
    const MastoidImages made = MakeMastoid(progress);
    MakeOutputFolder(folder);
    WriteImage(state.VolumeFile, made.Volume);
    WriteImage(state.SegmentationFile, made.Labels);
  }
  SceneStructure bone;
  bone.Id = 3;
  bone.Name = "Mastoid bone";
  bone.File = state.VolumeFile;
  bone.Iso = 300.0; // HU
  bone.Representation = TouchRepresentation::SubVoxel;
  bone.Color = {{0.93, 0.87, 0.74}};
  bone.Stiffness = 1.0;
  bone.Drill = {0.05, 0.002, 0.25}; // the window's cortical bone
  SceneStructure nerve = LabelOf(state.SegmentationFile, 1, 1, "Facial nerve");
  nerve.Color = {{0.95, 0.8, 0.1}};
  nerve.AlarmDistance = 1.5;
  SceneStructure sinus = LabelOf(state.SegmentationFile, 2, 2, "Sigmoid sinus");
  sinus.Color = {{0.2, 0.4, 0.8}};
  for (SceneStructure* one : {&nerve, &sinus})
  {
    one->IsTouchable = false;
    one->IsForbidden = true;
    one->Appearance = SceneAppearance::Surface;
  }
  state.Structures = {bone, nerve, sinus};
  state.Tool.Points = 0;
  state.View.Window = 3000.0;
  state.View.Level = 500.0;
  return state;
}

// Star-shaped deep structures, as in the examples of `palpate fit`.
StudyState Head(const ProgressFunction& progress)
{
  constexpr std::array<const char*, 8> Names{"Thalamus_L",    "Thalamus_R",   "Pallidum_L",
                                             "Pallidum_R",    "Amygdala_L",   "Amygdala_R",
                                             "Cerebelum_9_L", "Cerebelum_9_R"};
  const std::vector<std::filesystem::path> files = HeadFiles();
  ReportProgress(progress, 0.0, "reading the structures");
  StudyState state;
  state.VolumeFile = files[0];
  state.SegmentationFile = files[1];
  state = WithStructuresOf(state, ReadSegmentation(files[1], state.LeftHanded));
  for (SceneStructure& structure : state.Structures)
  {
    const bool isChosen = std::find(Names.begin(), Names.end(), structure.Name) != Names.end();
    structure.IsVisible = isChosen;
    structure.IsTouchable = isChosen;
  }
  return state;
}
} // namespace

std::vector<std::filesystem::path> HeadFiles()
{
  const std::filesystem::path folder = "/usr/share/mricron/templates";
  return {folder / "ch2.nii.gz", folder / "aal.nii.gz"};
}

StudyState MakeSampleScene(SampleScene scene, const std::filesystem::path& folder,
                           const ProgressFunction& progress)
{
  const std::filesystem::path absolute = StudyPath(folder);
  switch (scene)
  {
  case SampleScene::Prostate:
    return Prostate(absolute / "prostate", progress);
  case SampleScene::Lesion:
    return Lesion(absolute / "lesion", progress);
  case SampleScene::Mastoid:
    return Mastoid(absolute / "mastoid", progress);
  case SampleScene::Head:
    break;
  }
  return Head(progress);
}

StudyState CompareMasks(const std::filesystem::path& first, const std::filesystem::path& second,
                        const ProgressFunction& progress)
{
  constexpr double Translucent = 0.5;
  StudyState state;
  state.SegmentationFile = StudyPath(first);
  ReportProgress(progress, 0.0, "reading " + first.filename().string());
  state = WithStructuresOf(state, ReadSegmentation(state.SegmentationFile, state.LeftHanded));
  const std::size_t ofFirst = state.Structures.size();
  ReportProgress(progress, 0.5, "reading " + second.filename().string());
  state = WithAddedStructuresOf(state, StudyPath(second),
                                ReadSegmentation(StudyPath(second), state.LeftHanded));
  for (std::size_t n = 0; n < state.Structures.size(); ++n)
  {
    SceneStructure& structure = state.Structures[n];
    structure.Appearance = SceneAppearance::Surface;
    structure.Opacity = n < ofFirst ? 1.0 : Translucent;
  }
  return state;
}
} // namespace palpate
