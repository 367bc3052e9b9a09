#include "SceneMove.h"

#include "LabelValues.h"
#include "Refusal.h"
#include "TransformFile.h"
#include "TransformedImage.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <Eigen/SVD>
#include <algorithm>
#include <map>
#include <variant>

namespace palpate
{
bool operator==(const SceneMove& a, const SceneMove& b)
{
  return a.File == b.File && a.Fixed == b.Fixed;
}

Eigen::Affine3d ReadMove(const SceneMove& move, const std::filesystem::path& moving)
{
  constexpr double MostStretch = 100.0; // no two patients differ by as much
  const Eigen::Affine3d map = ReadTransform(move.File, {moving, move.Fixed});
  const Eigen::Matrix3d linear = map.linear();
  if (linear.determinant() < 0.0)
  {
    Refuse(move.File, "mirrors the patient", "register again");
  }
  const Eigen::Vector3d stretches = Eigen::JacobiSVD<Eigen::Matrix3d>(linear).singularValues();
  if (!(stretches[0] <= MostStretch && stretches[2] >= 1.0 / MostStretch))
  {
    Refuse(move.File, "stretches or shrinks the patient a hundredfold",
           "check its unit (mm), or register again");
  }
  return map;
}

Volume Moved(const Eigen::Affine3d& map, Volume volume)
{
  volume.Image = MoveAxes(volume.Source, volume.Image, map, ResamplingKind::Linear, volume.Notes);
  return volume;
}

void RemoveEmptySegments(Segmentation& segmentation)
{
  std::vector<std::map<int, vtkIdType>> counts;
  for (const vtkSmartPointer<vtkImageData>& layer : segmentation.Layers)
  {
    counts.push_back(CountLabels(layer->GetPointData()->GetScalars()));
  }
  auto& segments = segmentation.Segments;
  segments.erase(
      std::remove_if(segments.begin(), segments.end(),
                     [&counts](const Segment& one)
                     { return counts[static_cast<std::size_t>(one.Layer)].count(one.Value) == 0; }),
      segments.end());
}

Segmentation Moved(const Eigen::Affine3d& map, Segmentation segmentation)
{
  const std::vector<std::string> before = segmentation.Notes;
  for (vtkSmartPointer<vtkImageData>& layer : segmentation.Layers)
  {
    segmentation.Notes = before; // those of each layer are the same
    layer = MoveAxes(segmentation.Source, layer, map, ResamplingKind::Nearest, segmentation.Notes);
  }
  if (segmentation.Notes != before)
  {
    RemoveEmptySegments(segmentation); // of a voxel or two, between the resampled ones
  }
  return segmentation;
}

vtkSmartPointer<vtkPolyData> Moved(const Eigen::Affine3d& map, vtkPolyData* surface)
{
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = map.matrix();
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(rows.data());
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

OrganModel Moved(const Eigen::Affine3d& map, const OrganModel& model)
{
  const auto* radial = std::get_if<RadialModel>(&model);
  const SurfaceModel surface =
      radial != nullptr ? SurfaceModel::FromModel(*radial) : std::get<SurfaceModel>(model);
  return surface.Transformed(map.linear(), map.translation());
}
} // namespace palpate
