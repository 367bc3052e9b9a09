#include "TouchTexture.h"

#include "FieldOfImage.h"
#include "FilterRun.h"
#include "Refusal.h"
#include "Volume.h"

namespace palpate
{
std::shared_ptr<const SurfaceTexture> MakeTouchTexture(const std::filesystem::path& image,
                                                       const Eigen::AlignedBox3d& boundsWorld,
                                                       double amplitude,
                                                       const ProgressFunction& progress)
{
  const Volume volume = ReadVolume(image);
  FieldSamples samples;
  Status status = SamplesOfImage(volume.Image, samples);
  const FieldGrid grid = GridOfImage(volume.Image);
  FieldBuilder builder(grid);
  const int channel = builder.AddChannel(samples);
  // A field keeps the samples near its surfaces; which surface does not matter where all are near.
  const double* range = volume.Image->GetScalarRange();
  builder.AddMaterial({channel, 0.5 * (range[0] + range[1])});
  const auto& size = grid.Size();
  builder.SetMargin(grid.VectorWorld(Vector3(size[0], size[1], size[2])).norm());
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
  RequireInput(status, image.string());
  return texture;
}
} // namespace palpate
