#include "CohortReading.h"

#include "CohortTable.h"
#include "ExceptionMessage.h"
#include "InputError.h"
#include "ModelSurface.h"
#include "Progress.h"
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
constexpr double ReadingShare = 0.6; // of the progress; the rest is pictures

QImage PictureOf(const OrganModel& model)
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
  this->Percent = 0;
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

bool CohortReading::Report(double fraction)
{
  const int percent = static_cast<int>(100.0 * fraction);
  if (percent != this->Percent && !this->IsCancelled)
  {
    this->Percent = percent;
    Q_EMIT this->Progressed(percent);
  }
  return !this->IsCancelled;
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
    product->Group =
        MakeCohortGroup(table, path, "", AlignmentAxes::Patient,
                        [this](double done) { return this->Report(ReadingShare * done); });
    const auto count = static_cast<double>(product->Group.Models.size());
    for (const OrganModel& model : product->Group.Models)
    {
      const double drawn = static_cast<double>(product->Pictures.size()) / count;
      if (!this->Report(ReadingShare + (1.0 - ReadingShare) * drawn))
      {
        return;
      }
      product->Pictures.push_back(PictureOf(model));
    }
    Q_EMIT this->Done(product);
  }
  catch (const Cancelled&)
  {
    return;
  }
  catch (const std::exception& error)
  {
    Q_EMIT this->Failed(QString::fromStdString(MessageOf(error)));
  }
}
} // namespace palpate
