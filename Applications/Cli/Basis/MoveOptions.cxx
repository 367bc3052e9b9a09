#include "MoveOptions.h"

#include "FileFormat.h"
#include "FileType.h"
#include "ImageContent.h"
#include "InputError.h"
#include "SceneMove.h"
#include "TransformFile.h"
#include "TransformedImage.h"

#include <CLI/CLI.hpp>
#include <utility>

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
  this->Map = ReadMove({this->File, this->Reference}, input);
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
  for (vtkSmartPointer<vtkImageData>& layer : segmentation.Layers)
  {
    layer = this->Moved(layer, ResamplingKind::Nearest);
  }
  RemoveEmptySegments(segmentation); // those outside of the new grid
  if (segmentation.Segments.empty())
  {
    throw InputError(this->Input.string() + " has no structure within " + this->Reference.string() +
                     "; check the direction of the transform");
  }
  return segmentation;
}

vtkSmartPointer<vtkPolyData> MoveOptions::Moved(vtkPolyData* surface) const
{
  return this->IsGiven() ? palpate::Moved(this->Map, surface)
                         : vtkSmartPointer<vtkPolyData>(surface);
}

OrganModel MoveOptions::Moved(const OrganModel& model) const
{
  return this->IsGiven() ? palpate::Moved(this->Map, model) : model;
}
} // namespace palpate::cli
