#include "TransformedImage.h"

#include "Refusal.h"

#include "vtkPointData.h"

#include <Eigen/LU>

namespace palpate
{
vtkSmartPointer<vtkImageData> ResampleMoved(const std::filesystem::path& file, vtkImageData* image,
                                            const Eigen::Affine3d& map, const ImageGrid& onto,
                                            ResamplingKind kind)
{
  const ImageGrid from = GridOf(image);
  // Where the voxels of the new grid come from, as a grid in the space of the image.
  const Eigen::Affine3d back = map.inverse();
  Eigen::Affine3d steps = Eigen::Affine3d::Identity();
  steps.linear() = back.linear() * onto.Direction * onto.Spacing.asDiagonal();
  steps.translation() = back * onto.OriginWorld;
  return MakeImage(onto, ResampledVoxels(file, image, onto.Size, IndexMap(from, steps), kind));
}

vtkSmartPointer<vtkImageData> MoveRigidly(const std::filesystem::path& file, vtkImageData* image,
                                          const Eigen::Affine3d& map)
{
  constexpr double Rounding = 1e-4; // of transforms in single precision
  const Eigen::Matrix3d turn = map.linear();
  if (!(turn.transpose() * turn).isIdentity(Rounding) || turn.determinant() < 0.0)
  {
    Refuse(file, "would be stretched or mirrored by the transform",
           "name the image whose grid it is to have by --reference");
  }
  ImageGrid grid = GridOf(image);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(turn, Eigen::ComputeFullU | Eigen::ComputeFullV);
  grid.Direction = svd.matrixU() * svd.matrixV().transpose() * grid.Direction;
  grid.OriginWorld = map * grid.OriginWorld;
  return MakeImage(grid, image->GetPointData()->GetScalars());
}

vtkSmartPointer<vtkImageData> MoveAxes(const std::filesystem::path& file, vtkImageData* image,
                                       const Eigen::Affine3d& map, ResamplingKind kind,
                                       std::vector<std::string>& notes)
{
  ImageGrid grid = GridOf(image);
  const Eigen::Matrix3d steps = map.linear() * grid.Direction * grid.Spacing.asDiagonal();
  grid.Spacing = steps.colwise().norm();
  grid.Direction = steps.colwise().normalized();
  grid.OriginWorld = map * grid.OriginWorld;
  CheckGrid(file, grid, notes, ShearedAxes::Resample);
  vtkSmartPointer<vtkImageData> moved = MakeImage(grid, image->GetPointData()->GetScalars());
  if (!IsSheared(grid))
  {
    return moved;
  }
  notes.emplace_back(ResamplingNote);
  return ResampleSheared(file, moved, kind);
}
} // namespace palpate
