#include "StudyThumbnails.h"

#include "InputError.h"
#include "RecentFiles.h"
#include "ViewPicture.h"

#include <QCryptographicHash>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QPainter>
#include <QPainterPath>
#include <QSettings>

namespace palpate
{
namespace
{
const QSize KeptSize(256, 192); // pixels

QString NameOf(const QString& file)
{
  return QCryptographicHash::hash(file.toUtf8(), QCryptographicHash::Sha1).toHex() + ".png";
}

// Pictures of files that are no longer listed as recent.
void RemoveOthers(const QDir& folder, const QString& kept)
{
  QStringList names{kept};
  for (const QString& file : RecentFiles())
  {
    names += NameOf(file);
  }
  for (const QString& name : folder.entryList({"*.png"}, QDir::Files))
  {
    if (!names.contains(name))
    {
      QFile::remove(folder.filePath(name));
    }
  }
}

// A sheet of paper.
QImage PlainPicture(const QSize& size)
{
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(QColor("#1d232b"));
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(size.width() / 64.0, size.height() / 48.0);
  QPainterPath sheet(QPointF(22, 8));
  for (const QPointF& corner :
       {QPointF(36, 8), QPointF(43, 15), QPointF(43, 40), QPointF(22, 40), QPointF(22, 8)})
  {
    sheet.lineTo(corner);
  }
  painter.setPen(QPen(QColor("#8d99a6"), 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(sheet);
  painter.drawLine(QPointF(27, 24), QPointF(38, 24));
  painter.drawLine(QPointF(27, 31), QPointF(38, 31));
  return image;
}
} // namespace

StudyThumbnails::StudyThumbnails(StudyController& study, ViewGrid& views, QWidget* window)
    : QObject(window), Study(study), Views(views)
{
  connect(&study, &StudyController::Saved, this, &StudyThumbnails::Keep);
  connect(&study, &StudyController::Leaving, this, &StudyThumbnails::Keep);
  window->installEventFilter(this);
}

QString StudyThumbnails::Folder()
{
  return QFileInfo(QSettings().fileName()).absolutePath() + "/thumbnails";
}

bool StudyThumbnails::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::Close)
  {
    this->Keep();
  }
  return QObject::eventFilter(object, event);
}

void StudyThumbnails::Keep()
{
  const std::filesystem::path& file = this->Study.Current().File();
  constexpr auto OwnerAlone = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;
  if (file.empty() || !this->Views.isVisible() || !QDir().mkpath(Folder()) ||
      !QFile::setPermissions(Folder(), OwnerAlone))
  {
    return; // a start page without a picture is good enough
  }
  const bool hasSurface = !this->Study.State().Structures.empty();
  ViewPane* pane = hasSurface ? static_cast<ViewPane*>(this->Views.Space())
                              : this->Views.Slice(SliceOrientation::Axial);
  const QString name = NameOf(QString::fromStdString(file.string()));
  try
  {
    WritePicture(palpate::PictureOf(*pane, KeptSize, PictureGround::AsShown),
                 (Folder() + "/" + name).toStdString());
    RemoveOthers(QDir(Folder()), name);
  }
  catch (const InputError&)
  {
    return;
  }
}

QImage StudyThumbnails::PictureOf(const QString& file, const QSize& size)
{
  const QImage kept(Folder() + "/" + NameOf(file));
  if (kept.isNull())
  {
    return PlainPicture(size);
  }
  return kept.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}
} // namespace palpate
