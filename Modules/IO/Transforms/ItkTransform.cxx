// ITK has headers of an Eigen of its own: this file is compiled alone.
#include "ItkTransform.h"

#include "CNumericLocale.h"
#include "ItkCompiler.h"
#include "ItkMapRows.h"
#include "QuietStandardStreams.h"
#include "Refusal.h"

#include "itkTransformFactoryBase.h"
#include "itkTranslationTransform.h"
#include "itkTxtTransformIO.h"

#include <exception>

namespace palpate
{
namespace
{
using Linear = itk::MatrixOffsetTransformBase<double, 3, 3>;
using Translation = itk::TranslationTransform<double, 3>;

MapRows RowsOf(const Translation& shift)
{
  MapRows rows{};
  for (unsigned row = 0; row < 3; ++row)
  {
    rows[row][row] = 1.0;
    rows[row][3] = shift.GetOffset()[row];
  }
  return rows;
}
} // namespace

MapRows ReadItkTransform(const std::filesystem::path& file)
{
  const auto reader = itk::TxtTransformIOTemplate<double>::New();
  try
  {
    const CNumericLocale locale;
    const QuietStandardStreams quiet;
    itk::TransformFactoryBase::RegisterDefaultTransforms();
    reader->SetFileName(file.string());
    reader->Read();
  }
  catch (const std::exception&)
  {
    Refuse(file, "is not a transform of ITK, or is damaged", "write it again as text (.tfm)");
  }
  const auto& list = reader->GetReadTransformList();
  const auto* first = list.size() == 1 ? list.front().GetPointer() : nullptr;
  if (const auto* linear = dynamic_cast<const Linear*>(first))
  {
    return RowsOf(*linear);
  }
  if (const auto* shift = dynamic_cast<const Translation*>(first))
  {
    return RowsOf(*shift);
  }
  Refuse(file, "has no linear transform of three dimensions, or several of them",
         "write one rigid, similarity or affine transform");
}
} // namespace palpate
