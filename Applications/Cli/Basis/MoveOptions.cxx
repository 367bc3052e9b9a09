#include "MoveOptions.h"

#include "FileFormat.h"
#include "FileType.h"
#include "ImageContent.h"
#include "InputError.h"
#include "LabelValues.h"
#include "SurfaceModel.h"
#include "TransformFile.h"
#include "TransformedImage.h"

#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <utility>
#include <variant>

namespace palpate::cli
{
void MoveOptions::Declare(CLI::App& app)
{
  app.add_option("--transform", this->File,
                 "Move the input first, by a transform from it to another image: " +
                     ListOfEndings(TransformEndings()) + ", as palpate register writes it")
      ->type_name("FILE")
      ->check(FileType::Input("file"));
  app.add_option("--reference", this->Reference,
                 "Resample a moved image or segmentation on the voxels of this image (default: "
                 "its own voxels, at another place)")
      ->type_name("IMAGE")
      ->check(FileType::Input("file"));
}

void MoveOptions::Read(const std::filesystem::path& input)
{
  this->Input = input;
  if (!this->IsGiven())
  {
    if (!this->Reference.empty())
    {
      throw InputError("--reference needs --transform; leave it out");
    }
    return;
  }
  this->Map = ReadTransform(this->File, {input, this->Reference});
  if (this->Map.linear().determinant() < 0.0)
  {
    throw InputError(this->File.string() + " mirrors the patient; register again");
  }
  if (!this->Reference.empty())
  {
    const ImageContent content = ReadImageContent(this->Reference);
    this->Grid = GridOf(content.Image ? content.Image->Image : content.Labels->Layers.front());
  }
}

vtkSmartPointer<vtkImageData> MoveOptions::Moved(vtkImageData* image, ResamplingKind kind) const
{
  if (!this->IsGiven())
  {
    return image;
  }
  return this->Grid ? ResampleMoved(this->Input, image, this->Map, *this->Grid, kind)
                    : MoveRigidly(this->Input, image, this->Map);
}

Segmentation MoveOptions::Moved(Segmentation segmentation) const
{
  if (!this->IsGiven())
  {
    return segmentation;
  }
  std::vector<std::map<int, vtkIdType>> counts;
  for (vtkSmartPointer<vtkImageData>& layer : segmentation.Layers)
  {
    layer = this->Moved(layer, ResamplingKind::Nearest);
    counts.push_back(CountLabels(layer->GetPointData()->GetScalars()));
  }
  // Structures that lie outside of the new grid.
  auto& segments = segmentation.Segments;
  segments.erase(
      std::remove_if(segments.begin(), segments.end(),
                     [&counts](const Segment& one)
                     { return counts[static_cast<std::size_t>(one.Layer)].count(one.Value) == 0; }),
      segments.end());
  if (segments.empty())
  {
    throw InputError(this->Input.string() + " has no structure within " + this->Reference.string() +
                     "; check the direction of the transform");
  }
  return segmentation;
}

vtkSmartPointer<vtkPolyData> MoveOptions::Moved(vtkPolyData* surface) const
{
  if (!this->IsGiven())
  {
    return surface;
  }
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = this->Map.matrix();
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(rows.data());
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

OrganModel MoveOptions::Moved(const OrganModel& model) const
{
  if (!this->IsGiven())
  {
    return model;
  }
  const auto* radial = std::get_if<RadialModel>(&model);
  const SurfaceModel surface =
      radial != nullptr ? SurfaceModel::FromModel(*radial) : std::get<SurfaceModel>(model);
  return surface.Transformed(this->Map.linear(), this->Map.translation());
}
} // namespace palpate::cli
