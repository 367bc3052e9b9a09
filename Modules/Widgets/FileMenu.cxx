#include "FileMenu.h"

#include "CohortWindow.h"
#include "ImageFormat.h"
#ifdef PALPATE_HAS_NETWORK
#include "LinkDialog.h"
#endif
#include "ModelFile.h"
#include "ReadyTask.h"
#include "RecentFiles.h"
#include "ScreenString.h"
#include "SurfaceFile.h"
#include "ThresholdDialog.h"
#include "ToolIcon.h"

#include <QFileInfo>

namespace palpate
{
namespace
{
constexpr const char* StudyFilter = "Palpate studies (*.palpate.json)";

QString ImageFilter()
{
  return QString::fromStdString("Images (" + PatternsOf(ReadableImageEndings()) +
                                ");;All files (*)");
}

std::string ScenePatterns()
{
  return "*.scene.json " + PatternsOf(ReadableModelEndings()) + " " +
         PatternsOf(SurfaceFormats().ReadEndings());
}

QString SceneFilter()
{
  return QString::fromStdString("Models, surfaces, scenes (" + ScenePatterns() +
                                ");;All files (*)");
}

QString AnyFilter()
{
  return QString::fromStdString("All known files (*.palpate.json *.mrk.json *.touch " +
                                ScenePatterns() + " " + PatternsOf(ReadableImageEndings()) +
                                ");;All files (*)");
}

std::filesystem::path PathOf(const QString& file)
{
  return file.toStdString();
}
} // namespace

FileMenu::FileMenu(StudyController& study, const FileQuestions& questions,
                   const ViewContents& contents, QWidget* window)
    : QMenu("&File", window), Study(study), Questions(questions), Contents(contents), Window(window)
{
  this->AddOpening();
  this->addSeparator();
  this->AddTasks();
  this->addSeparator();
  this->AddSaving();
  this->addSeparator();
  this->addAction("&Quit", window, &QWidget::close, QKeySequence::Quit);
  connect(&study, &StudyController::FileOpened, this, &RememberRecent);
}

void FileMenu::AddOpening()
{
  this->addAction(
      "&New study", this,
      [this]
      {
        if (this->MayLeave())
        {
          this->Study.New();
        }
      },
      QKeySequence::New);
  QAction* open = this->addAction("&Open...", this, &FileMenu::OpenFiles, QKeySequence::Open);
  open->setIcon(ToolIcon(ToolSign::Open));
  open->setIconText("Open");
  open->setPriority(QAction::HighPriority);
  this->addAction("Open &volume...", this,
                  [this] { this->Open("Open a volume", &StudyController::OpenVolume); });
  this->addAction(
      "Open &segmentation...", this,
      [this] { this->Open("Open a segmentation", &StudyController::OpenSegmentation); },
      QKeySequence("Ctrl+Shift+O"));
  this->addAction("Open &folder...", this, &FileMenu::OpenFolder, QKeySequence("Ctrl+D"));
  this->addAction(
      "Add vol&ume over it...", this,
      [this] { this->Open("Add a volume over the first one", &StudyController::AddVolume); },
      QKeySequence("Ctrl+Alt+V"));
  QAction* labels = this->addAction(
      "Add structures of a se&gmentation...", this,
      [this] { this->Open("Add structures of a segmentation", &StudyController::AddSegmentation); },
      QKeySequence("Ctrl+Alt+S"));
  QAction* models = this->addAction(
      "Add &model, surface or scene...", this,
      [this] { this->OpenAny("Add models, surfaces or scenes", SceneFilter()); },
      QKeySequence("Ctrl+Alt+M"));
  QAction* values = this->addAction("Add structure from &image values...", this,
                                    &FileMenu::AddFromValues, QKeySequence("Ctrl+Alt+I"));
  this->ForAdding = {labels, values, models};
  this->addAction(
      "Open s&tudy...", this,
      [this]
      {
        const QStringList files = this->Questions.ToOpen(this->Window, "Open a study", StudyFilter);
        if (!files.isEmpty())
        {
          this->OpenSession(files.front());
        }
      },
      QKeySequence("Ctrl+Alt+O"));
  this->addAction("Open co&hort...", this, &FileMenu::OpenCohort, QKeySequence("Ctrl+Alt+H"));
  this->Recent = this->addMenu("&Recent");
  connect(this->Recent, &QMenu::aboutToShow, this, &FileMenu::ListRecent);
#ifdef PALPATE_HAS_NETWORK
  this->addAction("&Link with other programs...", this, &FileMenu::OpenLink,
                  QKeySequence("Ctrl+Alt+L"));
#endif
  this->ForTools = {open};
}

void FileMenu::AddTasks()
{
  this->addAction("&Run a task...", this, &FileMenu::TaskAsked, QKeySequence("Ctrl+Alt+T"));
  QMenu* ready = this->addMenu("Run a read&y task");
  ready->setToolTipsVisible(true);
  for (std::size_t n = 0; n < TaskKindNames().size(); ++n)
  {
    const auto kind = static_cast<TaskKind>(n);
    QAction* action = ready->addAction(QString::fromStdString(ReadyTaskTitle(kind)) + "...", this,
                                       [this, kind] { Q_EMIT this->ReadyTaskAsked(kind); });
    action->setToolTip("With made phantoms, in a folder that you choose");
  }
}

void FileMenu::AddSaving()
{
  QAction* save = this->addAction("&Save", this, &FileMenu::Save, QKeySequence::Save);
  save->setIcon(ToolIcon(ToolSign::Save));
  this->addAction("Save &as...", this, &FileMenu::SaveAs, QKeySequence("Ctrl+Shift+S"));
  QAction* picture =
      this->addAction("Save pi&cture...", this, &FileMenu::PictureAsked, QKeySequence("Ctrl+P"));
  picture->setIcon(ToolIcon(ToolSign::Screenshot));
  picture->setToolTip("Save a picture of a view, of all views, or of the window");
  this->ForTools += {save, picture};
}

void FileMenu::Open(const QString& title,
                    void (StudyController::*take)(const std::filesystem::path&))
{
  for (const QString& file : this->Questions.ToOpen(this->Window, title, ImageFilter()))
  {
    (this->Study.*take)(PathOf(file));
  }
}

void FileMenu::OpenFiles()
{
  this->OpenAny("Open files", AnyFilter());
}

void FileMenu::OpenAny(const QString& title, const QString& filter)
{
  std::vector<std::filesystem::path> files;
  for (const QString& file : this->Questions.ToOpen(this->Window, title, filter))
  {
    files.push_back(PathOf(file));
  }
  this->Study.OpenFiles(files);
}

// Beside the window, in which the slices show the values that are chosen.
void FileMenu::AddFromValuesOf(int volumeId)
{
  auto* open = this->Window->findChild<ThresholdDialog*>();
  if (open != nullptr && open->isVisible())
  {
    open->raise();
    open->activateWindow();
    return;
  }
  if (this->Study.Current().Pipeline().Newest<Volume>(SceneStep::Volume, volumeId) == nullptr)
  {
    this->Study.Report(
        "There is no volume to take values of: open one, and wait until it is read.");
    return;
  }
  auto* dialog = new ThresholdDialog(this->Study, this->Contents.Images(), this->Window, volumeId);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

CohortWindow* FileMenu::OpenCohort()
{
  auto* cohort = this->Window->findChild<CohortWindow*>();
  if (cohort == nullptr)
  {
    cohort = new CohortWindow(this->Questions, this->Window);
    cohort->setAttribute(Qt::WA_DeleteOnClose);
  }
  cohort->show();
  cohort->raise();
  cohort->activateWindow();
  return cohort;
}

#ifdef PALPATE_HAS_NETWORK
// Beside the window, in which what arrives is seen.
void FileMenu::OpenLink()
{
  auto* dialog = this->Window->findChild<LinkDialog*>();
  if (dialog == nullptr)
  {
    dialog = new LinkDialog(this->Study, this->Questions, this->Window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}
#endif

void FileMenu::OpenFolder()
{
  const QString folder =
      this->Questions.Folder(this->Window, "Open a folder of DICOM slices or of masks");
  if (!folder.isEmpty())
  {
    this->Study.OpenVolume(PathOf(folder));
  }
}

void FileMenu::OpenSession(const QString& file)
{
  if (this->MayLeave())
  {
    this->Study.OpenSession(PathOf(file));
  }
}

void FileMenu::AskForMissing()
{
  for (auto missing = MissingFiles(this->Study.State()); !missing.empty();
       missing = MissingFiles(this->Study.State()))
  {
    const QString found = this->Questions.Missing(this->Window, missing.front());
    if (found.isEmpty())
    {
      return;
    }
    this->Study.RelocateFile(missing.front().Path, PathOf(found));
  }
}

bool FileMenu::Save()
{
  const std::filesystem::path& file = this->Study.Current().File();
  return file.empty() ? this->SaveAs() : this->Study.Save(file);
}

bool FileMenu::SaveAs()
{
  const std::filesystem::path& former = this->Study.Current().ProposedFile();
  const QString proposal =
      former.empty() ? QString("study") + StudyEnding : QString::fromStdString(former.string());
  QString file = this->Questions.ToSave(this->Window, "Save the study", proposal, StudyFilter);
  if (file.isEmpty())
  {
    return false;
  }
  file += file.endsWith(StudyEnding) ? "" : StudyEnding;
  return this->Study.Save(PathOf(file));
}

bool FileMenu::MayLeave()
{
  if (!this->Study.Current().IsChanged())
  {
    return true;
  }
  switch (this->Questions.WhetherToSave(this->Window))
  {
  case FileQuestions::Answer::Save:
    return this->Save();
  case FileQuestions::Answer::Discard:
    return true;
  case FileQuestions::Answer::Cancel:
    break;
  }
  return false;
}

void FileMenu::ListRecent()
{
  this->Recent->clear();
  for (const QString& file : RecentFiles())
  {
    const QFileInfo information(file);
    const QString text = information.fileName() + "  -  " + information.path();
    QAction* action = this->Recent->addAction(MenuString(ScreenString(text.toStdString())));
    connect(action, &QAction::triggered, this, [this, file] { this->OpenRecent(file); });
  }
}

void FileMenu::OpenRecent(const QString& file)
{
  if (file.endsWith(StudyEnding))
  {
    this->OpenSession(file);
  }
  else
  {
    this->Study.OpenFiles({PathOf(file)});
  }
}
} // namespace palpate
