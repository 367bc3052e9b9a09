#include "LinkDialog.h"

#include "DisplayedSurface.h"
#include "IgtlConversion.h"
#include "IgtlTouchState.h"
#include "PlainLabel.h"
#include "ScreenString.h"
#include "vtkPolyData.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSettings>
#include <QStandardPaths>

namespace palpate
{
namespace
{
constexpr const char* AddressKey = "link/address";
constexpr const char* FolderKey = "link/folder";
constexpr int LinkLookMilliseconds = 50;

QString UsualFolder()
{
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/received";
}
} // namespace

LinkDialog::LinkDialog(StudyController& study, const FileQuestions& questions, QWidget* parent)
    : QDialog(parent), Study(study), Questions(questions),
      Address(new QLineEdit(QSettings().value(AddressKey, "18944").toString(), this)),
      Folder(new QLineEdit(QSettings().value(FolderKey, UsualFolder()).toString(), this)),
      Browse(new QPushButton("Choose...", this)),
      SendsSurfaces(new QCheckBox("Send the surfaces that are displayed", this)),
      Switch(new QPushButton("Start", this)), State(MakePlainLabel("link-state", this))
{
  this->setObjectName("link");
  this->setWindowTitle("Link with other programs");
  this->AddRows();
  connect(this->Browse, &QPushButton::clicked, this, &LinkDialog::ChooseFolder);
  connect(this->Switch, &QPushButton::toggled, this, &LinkDialog::SwitchLink);
  connect(&this->Study, &StudyController::ProductsChanged, this, &LinkDialog::OfferSurfaces);
  connect(&this->Study, &StudyController::StateChanged, this, &LinkDialog::OfferSurfaces);
  connect(&this->Study, &StudyController::Touched, this, &LinkDialog::ShowTouch);
  connect(&this->Study, &StudyController::TouchChanged, this, &LinkDialog::ShowTouch);
  connect(this->SendsSurfaces, &QCheckBox::toggled, this, &LinkDialog::OfferSurfaces);
  connect(&this->Timer, &QTimer::timeout, this, &LinkDialog::Look);
  this->Timer.setInterval(LinkLookMilliseconds);
  this->ShowState();
}

void LinkDialog::AddRows()
{
  auto* form = new QFormLayout(this);
  auto* what = new QLabel("Images and label maps that 3D Slicer or another program sends by "
                          "OpenIGTLink are opened here; it is shown where the tool is.",
                          this);
  what->setWordWrap(true);
  form->addRow(what);
  this->Address->setObjectName("link-address");
  this->Address->setToolTip("PORT: wait for a program on this machine; *:PORT: on any machine; "
                            "HOST:PORT: connect to one that waits");
  form->addRow("Port or address", this->Address);
  this->Folder->setObjectName("link-folder");
  auto* row = new QHBoxLayout;
  row->addWidget(this->Folder);
  row->addWidget(this->Browse);
  form->addRow("Received into", row);
  this->SendsSurfaces->setObjectName("link-surfaces");
  this->SendsSurfaces->setChecked(true);
  form->addRow(this->SendsSurfaces);
  this->State->setWordWrap(true);
  form->addRow(this->State);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  this->Switch->setObjectName("link-switch");
  this->Switch->setCheckable(true);
  buttons->addButton(this->Switch, QDialogButtonBox::ActionRole);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void LinkDialog::ChooseFolder()
{
  const QString folder = this->Questions.Folder(this, "Folder for received images");
  if (!folder.isEmpty())
  {
    this->Folder->setText(folder);
  }
}

void LinkDialog::SwitchLink(bool isOn)
{
  QString problem;
  if (isOn)
  {
    IgtlPeer peer;
    Status status = ParseIgtlPeer(this->Address->text().trimmed().toStdString(), peer);
    status = status.IsOk() ? this->Link.Open(peer) : status;
    problem = ScreenString(status.IsOk() ? "" : status.Message());
  }
  else
  {
    this->Link.Close();
    this->Timer.stop();
  }
  if (isOn && problem.isEmpty())
  {
    QSettings().setValue(AddressKey, this->Address->text());
    QSettings().setValue(FolderKey, this->Folder->text());
    this->Sent.clear();
    this->Quota = IgtlQuota();
    this->Timer.start();
    this->OfferSurfaces();
  }
  else if (isOn)
  {
    this->Switch->setChecked(false);
  }
  this->ShowState(problem);
}

void LinkDialog::ShowState(const QString& problem)
{
  const bool isOn = this->Timer.isActive();
  this->Switch->setText(isOn ? "Stop" : "Start");
  for (QWidget* setting :
       {static_cast<QWidget*>(this->Address), static_cast<QWidget*>(this->Folder),
        static_cast<QWidget*>(this->Browse)})
  {
    setting->setEnabled(!isOn);
  }
  QString text = "Not started.";
  if (isOn)
  {
    text = this->Link.HasPeer() ? QString("Connected.")
                                : QString("Waiting on port %1.").arg(this->Link.Port());
  }
  if (this->Quota.Images() > 0)
  {
    text += QString(" %1 images received.").arg(this->Quota.Images());
  }
  if (!problem.isEmpty())
  {
    text = problem + " " + text;
  }
  if (text != this->State->text())
  {
    this->State->setText(text);
  }
}

void LinkDialog::Look()
{
  QString problem;
  for (const std::string& one : this->Link.TakeProblems())
  {
    problem = ScreenString(one);
    this->Study.Report(one);
  }
  const Status status = this->TakeImages();
  if (!status.IsOk())
  {
    problem = ScreenString(status.Message() + ", so the link has ended; start it again for more.");
    this->Study.Report(problem.toStdString());
  }
  if (!status.IsOk() || this->Link.HasEnded())
  {
    this->Switch->setChecked(false);
    this->ShowState(problem);
    return;
  }
  this->ShowState();
}

// One at a time, so that images do not wait in memory. Fails if one is beyond the quota.
Status LinkDialog::TakeImages()
{
  while (this->Writing.expired())
  {
    std::optional<IgtlImage> image = this->Link.TakeImage();
    if (!image)
    {
      break;
    }
    Status status = this->Quota.Check(image->Voxels.size());
    if (!status.IsOk())
    {
      return status;
    }
    this->Quota.Add(image->Voxels.size());
    this->Keep(std::make_shared<const IgtlImage>(std::move(*image)));
  }
  return Status::Success();
}

// Written and then opened as any other file, so that a saved session finds it again.
void LinkDialog::Keep(std::shared_ptr<const IgtlImage> image)
{
  this->Writing = image;
  StudyController* study = &this->Study;
  StudyJob job;
  job.Work =
      [study, image = std::move(image),
       folder = std::filesystem::path(this->Folder->text().toStdString())](const ProgressFunction&)
  {
    const std::filesystem::path file = KeepImage(*image, folder);
    return StudyJob::Delivery([study, file] { study->OpenFiles({file}); });
  };
  job.Fail = [study](const std::string& message) { study->Report(message); };
  this->Study.Current().Jobs().Start(std::move(job));
}

std::vector<vtkSmartPointer<vtkPolyData>> LinkDialog::SurfacesToSend()
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  for (const SceneStructure& structure : this->Study.State().Structures)
  {
    vtkPolyData* surface = SurfaceOf(this->Study.Current().Pipeline(), structure);
    if (this->SendsSurfaces->isChecked() && structure.IsVisible && surface != nullptr &&
        surface->GetNumberOfCells() > 0)
    {
      surfaces.emplace_back(surface);
    }
  }
  return surfaces;
}

void LinkDialog::OfferSurfaces()
{
  if (!this->Timer.isActive())
  {
    return;
  }
  const std::vector<vtkSmartPointer<vtkPolyData>> surfaces = this->SurfacesToSend();
  std::vector<std::uint64_t> times; // no two data objects share one
  for (vtkPolyData* surface : surfaces)
  {
    times.push_back(surface->GetMTime());
  }
  if (times != this->Sent)
  {
    this->Sent = std::move(times);
    this->Link.Offer(SurfaceMessagesOf(surfaces));
  }
}

void LinkDialog::ShowTouch()
{
  const std::optional<IgtlTouch> shown = IgtlTouchOf(this->Study.Reading().Newest);
  if (!this->Study.IsTouching())
  {
    this->Link.EndTouch();
  }
  else if (this->Timer.isActive() && shown)
  {
    this->Link.Show(*shown);
  }
}

void LinkDialog::done(int result)
{
  this->Link.Close();
  this->Timer.stop();
  QDialog::done(result);
}
} // namespace palpate
