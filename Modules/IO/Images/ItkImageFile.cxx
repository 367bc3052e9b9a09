#include "ItkImageFile.h"

#include "ForeignFile.h"
#include "Refusal.h"

#include <algorithm>
#include <limits>

namespace palpate
{
void ItkImageFile::OpenReader(ItkFormat format, const std::string& name)
{
  try
  {
    this->Reader = std::make_unique<ItkImageReader>(this->File, format);
    this->Header = this->Reader->Header();
  }
  catch (const std::exception&)
  {
    RefuseContent(this->File, "is not in " + name + " format, or its header is damaged",
                  "copy or export it again");
  }
  this->CheckHeader();
  this->TakeGrid();
}

void ItkImageFile::CheckHeader() const
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
    Refuse(this->File, "has voxels of a type that is not supported",
           "convert it to integers or floating-point numbers");
  }
}

void ItkImageFile::TakeGrid()
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

void ItkImageFile::ReadInto(void* buffer)
{
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
