#pragma once

#include "StudyController.h"
#include "ViewGrid.h"

#include <QImage>
#include <QObject>

namespace palpate
{
/// Small pictures of the studies that were saved or left last, for the start page. They show what
/// the views showed, so only the user can open their folder; their names are digests of the
/// studies' paths.
class StudyThumbnails : public QObject
{
  Q_OBJECT

public:
  /// Keeps the addresses. Takes a picture whenever the study is saved or left, and when the window
  /// closes.
  StudyThumbnails(StudyController& study, ViewGrid& views, QWidget* window);

  /// The picture of a file, cut to this size (device pixels); a plain one if there is none.
  static QImage PictureOf(const QString& file, const QSize& size);
  /// The user's folder for them, beside the settings.
  static QString Folder();

  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void Keep();

  StudyController& Study;
  ViewGrid& Views;
};
} // namespace palpate
