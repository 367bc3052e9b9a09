#pragma once

#include "FileQuestions.h"
#include "IgtlLink.h"
#include "IgtlQuota.h"
#include "StudyController.h"
#include "vtkSmartPointer.h"

#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>

#include <cstdint>
#include <memory>
#include <vector>

class vtkPolyData;

namespace palpate
{
/// Exchanges data with another program by OpenIGTLink while it is open: images and label maps that
/// arrive are written into a folder and opened; the displayed surfaces of structures are sent,
/// again whenever they change, and where the tool is during a touch. Closing it ends the
/// connection.
class LinkDialog : public QDialog
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  LinkDialog(StudyController& study, const FileQuestions& questions, QWidget* parent);

  void done(int result) override;

private:
  void AddRows();
  void ChooseFolder();
  void SwitchLink(bool isOn);
  void Look();
  Status TakeImages();
  void Keep(std::shared_ptr<const IgtlImage> image);
  std::vector<vtkSmartPointer<vtkPolyData>> SurfacesToSend();
  void OfferSurfaces();
  void ShowTouch();
  void ShowState(const QString& problem = {});

  StudyController& Study;
  const FileQuestions& Questions;
  IgtlLink Link;
  QTimer Timer;
  QLineEdit* Address;
  QLineEdit* Folder;
  QPushButton* Browse;
  QCheckBox* SendsSurfaces;
  QPushButton* Switch;
  QLabel* State;
  IgtlQuota Quota;
  std::weak_ptr<const IgtlImage> Writing; ///< the next one waits until it is written
  std::vector<std::uint64_t> Sent;        ///< modification times of the surfaces that were offered
};
} // namespace palpate
