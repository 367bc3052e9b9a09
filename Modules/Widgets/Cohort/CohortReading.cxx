#include "CohortReading.h"

#include "CohortTable.h"
#include "ExceptionMessage.h"
#include "InputError.h"
#include "MaskFolderFit.h"
#include "ModelSurface.h"
#include "Progress.h"
#include "SoftwareRenderer.h"
#include "SoftwareVersions.h"

#include <QMetaType>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace palpate
{
namespace
{
constexpr int PictureFrequency = 12; // 1,442 points
constexpr int PictureSize = 48;      // pixels
constexpr double FittingShare = 0.9; // of the progress, if masks are fitted
constexpr double ReadingShare = 0.6; // of the rest, which then is pictures

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
  this->Run([this, folder] { this->Read(folder, 0.0); });
}

void CohortReading::StartFit(const QString& masks, const QString& output)
{
  this->Run([this, masks, output] { this->Fit(masks, output); });
}

void CohortReading::Run(std::function<void()> work)
{
  this->Cancel();
  qRegisterMetaType<std::shared_ptr<palpate::CohortReading::Product>>(
      "std::shared_ptr<palpate::CohortReading::Product>");
  this->IsCancelled = false;
  this->IsStopped = false;
  this->Percent = 0;
  this->Thread = std::thread(
      [this, work = std::move(work)]
      {
        try
        {
          work();
        }
        catch (const Cancelled&)
        {
          if (this->IsStopped)
          {
            Q_EMIT this->Stopped();
          }
        }
        catch (const std::exception& error)
        {
          Q_EMIT this->Failed(QString::fromStdString(MessageOf(error)));
        }
      });
}

void CohortReading::Stop()
{
  this->IsStopped = true;
  this->IsCancelled = true;
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

void CohortReading::Fit(const QString& masks, const QString& output)
{
  const std::string program = "palpate-viewer " + SoftwareVersions().front().second;
  FitMaskFolder(masks.toStdString(), output.toStdString(), FitSettings(), program,
                [this](double done, const std::string& stage)
                {
                  Q_EMIT this->StageReached(QString::fromStdString(stage));
                  return this->Report(FittingShare * done);
                });
  this->Read(output, FittingShare);
}

void CohortReading::Read(const QString& folder, double from)
{
  const std::filesystem::path path = folder.toStdString();
  const auto report = [this, from](double done)
  { return this->Report(from + (1.0 - from) * done); };
  auto product = std::make_shared<Product>();
  const CohortTable table = CohortTable::Read(path / "cohort.csv");
  if (table.Rows().empty())
  {
    throw InputError(path.string() +
                     " has no cohort.csv; choose a folder that `palpate fit` wrote from a folder "
                     "of masks, or fit the masks here");
  }
  product->Group = MakeCohortGroup(table, path, "", AlignmentAxes::Patient,
                                   [&report](double done) { return report(ReadingShare * done); });
  const auto count = static_cast<double>(product->Group.Models.size());
  for (const OrganModel& model : product->Group.Models)
  {
    const double drawn = static_cast<double>(product->Pictures.size()) / count;
    if (!report(ReadingShare + (1.0 - ReadingShare) * drawn))
    {
      throw Cancelled();
    }
    product->Pictures.push_back(PictureOf(model));
  }
  Q_EMIT this->Done(product);
}
} // namespace palpate
