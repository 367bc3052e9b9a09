#include "TouchTexture.h"

#include "FieldOfImage.h"
#include "FilterRun.h"
#include "ImageWithin.h"
#include "Refusal.h"
#include "SceneSettings.h"
#include "SurfaceTexture.h"

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
  const vtkSmartPointer<vtkImageData> image =
      ImageWithin(volume.Image, {boundsWorld.min() - margin, boundsWorld.max() + margin});
  FieldSamples samples;
  Status status = SamplesOfImage(image, samples);
  const FieldGrid grid = GridOfImage(image);
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
} // namespace

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
} // namespace palpate
