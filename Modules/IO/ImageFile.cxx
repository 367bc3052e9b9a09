#include "ImageFile.h"

#include "ForeignFile.h"
#include "ItkImageReader.h"
#include "MemoryCheck.h"
#include "MetaImageHeader.h"
#include "NiftiVoxels.h"
#include "NrrdHeader.h"
#include "NrrdLimits.h"
#include "NrrdSpace.h"
#include "Refusal.h"

#include <algorithm>
#include <limits>

namespace palpate
{
ImageFile::ImageFile(const std::filesystem::path& file, FileKind kind) : File(file), Kind(kind)
{
  if (kind == FileKind::Nifti)
  {
    this->OpenNifti();
    return;
  }
  if (kind == FileKind::Nrrd)
  {
    CheckNrrdLimits(file);
    this->OpenNrrd();
    return;
  }
  this->OpenMetaImage();
}

ImageFile::~ImageFile() = default;

void ImageFile::OpenNifti()
{
  const NiftiHeader header = ReadNiftiHeader(this->File);
  this->Nifti = std::make_unique<NiftiVoxels>(this->File, header);
  this->Header.Components = 1;
  this->Header.VtkType = this->Nifti->ScalarType();
  this->FileGrid.Size = header.Size;
  this->FileGrid.Spacing = header.Spacing;
  PlaceGrid(this->File, header.Orientation, this->FileGrid);
  CheckGrid(this->File, this->FileGrid);
  this->HeaderNotes = OrientationNotes(header.Orientation, this->FileGrid);
}

void ImageFile::OpenNrrd()
{
  CheckNrrdHeader(this->File);
  const NrrdSpace space(this->File, ReadNrrdFields(this->File));
  this->OpenReader();
  space.PlaceGrid(this->FileGrid);
  CheckGrid(this->File, this->FileGrid);
  this->HeaderNotes = space.Notes();
}

void ImageFile::OpenMetaImage()
{
  const MetaImageFacts facts = CheckMetaImageHeader(this->File);
  this->OpenReader();
  // What was checked must be what is read.
  const bool isSame =
      std::equal(facts.Size.begin(), facts.Size.end(), this->FileGrid.Size.begin()) &&
      this->Components() == 1 &&
      vtkDataArray::GetDataTypeSize(this->ScalarType()) == facts.VoxelBytes;
  if (!isSame)
  {
    Refuse(this->File, "has a header that can be read in two ways", "copy or export it again");
  }
  CheckGrid(this->File, this->FileGrid);
  this->HeaderNotes = facts.Notes;
}

void ImageFile::OpenReader()
{
  try
  {
    this->Reader = std::make_unique<ItkImageReader>(this->File, this->Kind);
    this->Header = this->Reader->Header();
  }
  catch (const std::exception&)
  {
    RefuseContent(this->File,
                  std::string("is no ") + FileKindName(this->Kind) +
                      " image or its header is damaged",
                  "copy or export it again");
  }
  this->CheckHeader();
  this->TakeGrid();
}

void ImageFile::CheckHeader() const
{
  const std::vector<long long>& size = this->Header.Size;
  for (std::size_t axis = 0; axis < size.size(); ++axis)
  {
    if (size[axis] < 1 || size[axis] > std::numeric_limits<int>::max())
    {
      Refuse(this->File, "has a damaged header", "copy or export it again");
    }
    if (axis > 2 && size[axis] > 1)
    {
      Refuse(this->File, "has " + std::to_string(size.size()) + " dimensions",
             "extract one three-dimensional volume of it");
    }
  }
  if (this->Header.VtkType == 0 || this->Header.Components < 1)
  {
    Refuse(this->File, "has voxels of a type that is not read",
           "convert it to integers or floating-point numbers");
  }
}

void ImageFile::TakeGrid()
{
  const std::size_t axes = std::min<std::size_t>(this->Header.Size.size(), 3);
  this->FileGrid.Size = {1, 1, 1};
  for (std::size_t axis = 0; axis < axes; ++axis)
  {
    const auto i = static_cast<Eigen::Index>(axis);
    this->FileGrid.Size[axis] = static_cast<int>(this->Header.Size[axis]);
    this->FileGrid.Spacing[i] = this->Header.Spacing[axis];
    this->FileGrid.OriginWorld[i] = this->Header.OriginWorld[axis];
    for (std::size_t row = 0; row < axes; ++row)
    {
      this->FileGrid.Direction(static_cast<Eigen::Index>(row), i) =
          this->Header.AxesWorld[axis][row];
    }
  }
}

double ImageFile::DataBytes() const
{
  return static_cast<double>(this->FileGrid.VoxelCount()) * this->Components() *
         vtkDataArray::GetDataTypeSize(this->ScalarType());
}

vtkSmartPointer<vtkDataArray> ImageFile::NewArray() const
{
  auto array =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(this->ScalarType()));
  const double bytes = this->DataBytes();
  if (this->Kind == FileKind::Nrrd)
  {
    CheckNrrdLength(this->File, bytes);
  }
  CheckMemory(this->File, bytes, AvailableMemoryBytes());
  array->SetNumberOfComponents(this->Components());
  array->SetNumberOfTuples(this->FileGrid.VoxelCount());
  return array;
}

void ImageFile::ReadInto(void* buffer)
{
  if (this->Nifti)
  {
    this->Nifti->ReadInto(buffer);
    return;
  }
  if (this->Kind == FileKind::Nrrd)
  {
    CheckNrrdData(this->File, static_cast<std::uint64_t>(this->DataBytes()));
  }
  try
  {
    this->Reader->ReadInto(buffer);
  }
  catch (const std::exception&)
  {
    Refuse(this->File, "cannot be read to its end: it is truncated or damaged",
           "copy or export it again");
  }
}
} // namespace palpate
