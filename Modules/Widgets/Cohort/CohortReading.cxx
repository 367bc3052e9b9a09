#include "CohortReading.h"

#include "CohortTable.h"
#include "InputError.h"
#include "ModelSurface.h"
#include "SoftwareRenderer.h"

#include <QMetaType>

#include <algorithm>
#include <filesystem>

namespace palpate
{
namespace
{
constexpr int PictureFrequency = 12; // 1,442 points
constexpr int PictureSize = 48;      // pixels

QImage PictureOf(const SurfaceModel& model)
{
  SoftwareRenderer renderer(DrawModel(model, PictureFrequency));
  renderer.SetColor({214, 160, 120});
  const RasterImage image = renderer.Render(ViewSide::Anterior, PictureSize);
  QImage picture(image.Width, image.Height, QImage::Format_RGBA8888);
  for (int row = 0; row < image.Height; ++row)
  {
    const auto* first = image.Rgba.data() +
                        static_cast<std::size_t>(row) * 4U * static_cast<std::size_t>(image.Width);
    std::copy(first, first + 4 * image.Width, picture.scanLine(row));
  }
  return picture;
}
} // namespace

void CohortReading::Start(const QString& folder)
{
  this->Cancel();
  qRegisterMetaType<std::shared_ptr<palpate::CohortReading::Product>>(
      "std::shared_ptr<palpate::CohortReading::Product>");
  this->IsCancelled = false;
  this->Thread = std::thread([this, folder] { this->Read(folder); });
}

void CohortReading::Cancel()
{
  this->IsCancelled = true;
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

void CohortReading::Read(const QString& folder)
{
  try
  {
    const std::filesystem::path path = folder.toStdString();
    auto product = std::make_shared<Product>();
    const CohortTable table = CohortTable::Read(path / "cohort.csv");
    if (table.Rows().empty())
    {
      throw InputError(
          path.string() +
          " has no cohort.csv; choose a folder that `palpate fit` wrote from a folder of "
          "masks");
    }
    product->Group = MakeCohortGroup(table, path, "", AlignmentAxes::Patient);
    for (const SurfaceModel& model : product->Group.Models)
    {
      if (this->IsCancelled)
      {
        return;
      }
      product->Pictures.push_back(PictureOf(model));
    }
    Q_EMIT this->Done(product);
  }
  catch (const std::exception& error)
  {
    Q_EMIT this->Failed(QString::fromStdString(error.what()));
  }
}
} // namespace palpate
