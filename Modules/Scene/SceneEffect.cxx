#include "SceneEffect.h"

#include "FieldOfImage.h"
#include "FilterRun.h"
#include "KindRegistration.h"
#include "NodeBox.h"
#include "Refusal.h"
#include "SceneSettings.h"
#include "SurfaceTexture.h"
#include "VolumeViscosity.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <utility>

namespace palpate
{
namespace
{
std::shared_ptr<const ForceEffect> MakeTexture(const SceneEffectSource& source, double amplitude,
                                               const ProgressFunction& progress)
{
  const Volume& volume = *source.Image;
  const Eigen::AlignedBox3d& boundsWorld = source.BoundsWorld;
  const Vector3 margin = Vector3::Constant(source.ToolReach);
  FieldGrid grid = GridOfImage(volume.Image);
  // One node more than needed, against rounding.
  const NodeBox nodes =
      NodesRound(grid, {boundsWorld.min() - margin, boundsWorld.max() + margin}, 1.0);
  vtkNew<vtkImageData> image;
  image->ShallowCopy(volume.Image);
  if (nodes.HasCells())
  {
    std::array<int, 6> extent{};
    image->GetExtent(extent.data());
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      extent[2 * axis + 1] = extent[2 * axis] + nodes.Last[axis];
      extent[2 * axis] += nodes.First[axis];
    }
    image->Crop(extent.data());
    grid = PartOf(grid, nodes);
  }
  FieldSamples samples;
  Status status = SamplesOfImage(image, samples);
  FieldBuilder builder(grid);
  const int channel = builder.AddChannel(samples);
  // A field needs a surface; any will do here, since all samples are kept.
  const double* range = image->GetScalarRange();
  if (status.IsOk() && range[0] == range[1])
  {
    status = Status::Failure("The image is constant around the structure, so it has no texture.");
  }
  builder.AddMaterial({channel, 0.5 * (range[0] + range[1])});
  builder.KeepAll();
  bool wasCancelled = false;
  std::shared_ptr<const ScalarField> field;
  if (status.IsOk())
  {
    status = builder.Build(field,
                           [&](double part)
                           {
                             wasCancelled = wasCancelled || !progress(part, "texture");
                             return !wasCancelled;
                           });
  }
  if (wasCancelled)
  {
    throw Cancelled();
  }
  std::shared_ptr<const SurfaceTexture> texture;
  if (status.IsOk())
  {
    status = SurfaceTexture::Make(field, channel, boundsWorld, amplitude, texture);
  }
  RequireInput(status, volume.Source.string());
  return texture;
}

// A small force from the intensities of an image (see SurfaceTexture). Only the part of the image
// where tool and structure can meet is kept in memory.
SceneEffectKind TextureKind()
{
  constexpr double Largest = 10.0; // N
  SceneEffectKind kind;
  kind.Name = "texture";
  kind.Numbers = {{"texture_n", "Texture, N", Largest, 3}};
  kind.ImageKey = "texture_image";
  kind.ImageLabel = "Texture image";
  kind.Make = [key = kind.Numbers.front().Key](const SceneEffectSource& source,
                                               const ProgressFunction& progress)
  { return MakeTexture(source, source.Structure.Number(key), progress); };
  return kind;
}

SceneEffectKind ViscosityKind()
{
  constexpr double Largest = 10.0; // N s/mm
  SceneEffectKind kind;
  kind.Name = "viscosity";
  kind.Numbers = {{"viscosity_ns_per_mm", "Viscosity inside, N s/mm", Largest, 5}};
  kind.Make = [key = kind.Numbers.front().Key](const SceneEffectSource& source,
                                               const ProgressFunction& /*progress*/)
  { return std::make_shared<const VolumeViscosity>(source.Structure.Number(key)); };
  return kind;
}

// Texture before viscosity: recordings replay the sum in this order.
std::deque<SceneEffectKind>& Kinds()
{
  static std::deque<SceneEffectKind> kinds{TextureKind(), ViscosityKind()};
  return kinds;
}
} // namespace

bool SceneEffectKind::IsIn(const SceneStructure& structure) const
{
  return structure.Number(this->Numbers.front().Key) != 0.0;
}

const std::deque<SceneEffectKind>& SceneEffectKinds()
{
  return Kinds();
}

void AddSceneEffectKind(SceneEffectKind kind)
{
  AddOrReplace(Kinds(), std::move(kind));
}

std::vector<const SceneEffectKind*> EffectsOf(const SceneStructure& structure)
{
  std::vector<const SceneEffectKind*> effects;
  for (const SceneEffectKind& kind : SceneEffectKinds())
  {
    if (kind.IsIn(structure))
    {
      effects.push_back(&kind);
    }
  }
  return effects;
}

std::size_t ImageEffects::Bytes() const
{
  std::size_t bytes = 0;
  for (const auto& [name, effect] : this->Made)
  {
    bytes += effect->Bytes();
  }
  return bytes;
}
} // namespace palpate
