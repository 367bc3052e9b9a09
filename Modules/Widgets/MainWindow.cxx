#include "MainWindow.h"

#include "CheckPanel.h"
#include "DrillPanel.h"
#include "FitPanel.h"
#include "FormManners.h"
#include "HelpMenu.h"
#include "PictureDialog.h"
#include "PipelineLine.h"
#include "PlotsPanel.h"
#include "PreferencesDialog.h"
#include "QualityPanel.h"
#include "RecentFiles.h"
#include "RelationsPanel.h"
#include "ReplayBar.h"
#include "ScreenString.h"
#include "StartLink.h"
#include "StructureLink.h"
#include "StructuresPanel.h"
#include "StudyThumbnails.h"
#include "ThresholdDialog.h"
#include "ToolRow.h"
#include "TouchPanel.h"
#include "ViewPicture.h"
#include "VolumePanel.h"
#include "VolumeRenderingLink.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

namespace palpate
{
namespace
{
constexpr int LeftWidth = 396; // pixels
constexpr int BottomHeight = 150;

// Names an action after the step of the study that it undoes or redoes.
void ShowStep(QAction* action, const QString& verb, const std::string& step)
{
  action->setEnabled(!step.empty());
  action->setText(step.empty() ? verb : verb + ": " + MenuString(ScreenString(step)));
}
} // namespace

MainWindow::MainWindow(StudyController& study, FileQuestions questions)
    : Study(study), Questions(std::move(questions))
{
  new FormManners(this);
  this->setAcceptDrops(true);
  this->setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  this->MakeCentre();
  this->MakeMenus();
  this->MakePanels();
  this->ConnectViews();
  this->Follow(Preferences::Kept());
  this->Keys = std::make_unique<KeyBindings>(this);
  connect(&study, &StudyController::StateChanged, this, &MainWindow::ShowState);
  connect(&study, &StudyController::ProductsChanged, this, &MainWindow::ShowState);
  connect(&study, &StudyController::ReplayChanged, this, &MainWindow::ShowCentre);
  connect(&study, &StudyController::StepsChanged, this, &MainWindow::ShowChange);
  connect(&study, &StudyController::DrilledChanged, this, &MainWindow::ShowChange);
  connect(&study, &StudyController::ViewChanged, this,
          [this] { this->Shown.ShowView(this->Study.State().View); });
  connect(&study, &StudyController::FileOpened, this, &MainWindow::TakeFile);
  connect(&study, &StudyController::Problem, this->Area, &MessageArea::Add);
  connect(&study, &StudyController::ProblemEnded, this->Area, &MessageArea::Remove);
  this->ShowState();
}

MainWindow::~MainWindow()
{
  this->EndEditing();
  delete this->Tasks;
  // It watches all events, also those of an open menu whose end follows that of the views.
  delete this->findChild<TouchLink*>(QString(), Qt::FindDirectChildrenOnly);
}

// A number that is being typed is taken when its box loses the focus: while all that it changes is
// there, and before the user is asked whether to save.
void MainWindow::EndEditing()
{
  if (QWidget* edited = this->focusWidget())
  {
    edited->clearFocus();
  }
}

void MainWindow::MakeCentre()
{
  auto* middle = new QWidget(this);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  this->Grid = new ViewGrid(this->Shown, middle);
  this->Area = new MessageArea(middle);
  this->Start = new StartPage(middle);
  column->addWidget(this->Start, 1);
  column->addWidget(this->Grid, 1);
  column->addWidget(new ReplayBar(this->Study, middle));
  column->addWidget(this->Area);
  this->setCentralWidget(middle);
  this->Status = new StatusLine(this->Study, this);
  this->setStatusBar(this->Status);
}

void MainWindow::MakeMenus()
{
  this->Files = new FileMenu(this->Study, this->Questions, this->Shown, this);
  this->Study.AskBeforeLeaving([this] { return this->Files->MayLeave(); });
  this->Study.AskForSeries([this](const std::vector<DicomSeriesChoice>& series)
                           { return this->Questions.Series(this, series); });
  connect(this->Files, &FileMenu::PictureAsked, this, &MainWindow::AskForPicture);
  this->MakeStart();
  this->menuBar()->addMenu(this->Files);
  QMenu* edit = this->menuBar()->addMenu("&Edit");
  this->Undo = edit->addAction("&Undo", &this->Study, &StudyController::Undo,
                               QKeySequence(QKeySequence::Undo));
  this->Redo = edit->addAction("&Redo", &this->Study, &StudyController::Redo,
                               QKeySequence(QKeySequence::Redo));
  edit->addSeparator();
  edit->addAction("&Preferences...", this, &MainWindow::AskForPreferences, QKeySequence("Ctrl+,"));
  this->Viewing = new ViewMenu(this->Study, this->Questions, *this->Grid, this->Shown, this);
  this->menuBar()->addMenu(this->Viewing);
  this->Touching = new TouchMenu(this->Study, this->Questions, this);
  this->menuBar()->addMenu(this->Touching);
  this->Panels = this->menuBar()->addMenu("Pa&nels");
  this->menuBar()->addMenu(new HelpMenu(this));
}

void MainWindow::MakeStart()
{
  auto* coach = new Coach(this->Study, this->centralWidget());
  qobject_cast<QVBoxLayout*>(this->centralWidget()->layout())->insertWidget(0, coach);
  new StartLink(this->Study, this->Questions, *this->Files, *this->Start, *coach, *this->Grid);
  new StudyThumbnails(this->Study, *this->Grid, this);
}

RecoveryLink* MainWindow::KeepRecovery(const std::filesystem::path& root)
{
  auto* link = new RecoveryLink(
      this->Study, root, [this] { return this->Files->MayLeave(); },
      [this](const QString& title) { return this->Questions.WhetherToDelete(this, title); }, this);
  qobject_cast<QVBoxLayout*>(this->centralWidget()->layout())->insertWidget(0, link->Offer());
  return link;
}

void MainWindow::AddSection(const QString& title, QWidget* content, bool isOpen)
{
  Section* section = this->Column->Add(title, content, isOpen);
  QAction* action = this->Panels->addAction(title);
  action->setCheckable(true);
  action->setChecked(section->IsOpen());
  connect(section, &Section::Opened, action, &QAction::setChecked);
  connect(action, &QAction::triggered, this,
          [this, section](bool isShown)
          { isShown ? this->Column->GoTo(section) : section->Open(false); });
}

// In the order of the work.
void MainWindow::MakeColumn()
{
  this->Column = new WorkColumn(this);
  auto* structures = new StructuresPanel(this->Study, this);
  connect(structures, &StructuresPanel::OpacityChosen, this,
          [this](double opacity) { this->Shown.Images()->SetLabelOpacity(opacity); });
  auto* touch = new TouchPanel(this->Study, this);
  this->Touching->Serve(*touch);
  connect(this->Touching, &TouchMenu::ValuesAsked, this,
          [this]
          {
            this->Files->AddFromValues();
            connect(this->findChild<ThresholdDialog*>(), &QDialog::accepted, &this->Study,
                    &StudyController::StartTouchSoon, Qt::UniqueConnection);
          });
  structures->AddAdding(this->Files->Adding());
  auto* volumes = new VolumePanel(this->Study, this->Shown, this->Questions, this);
  connect(volumes, &VolumePanel::ValuesAsked, this->Files, &FileMenu::AddFromValuesOf);
  this->AddSection("Data", volumes, true);
  this->AddSection("Structures", structures, true);
  auto* model = new QWidget(this);
  auto* options = new QVBoxLayout(model);
  options->setContentsMargins(0, 0, 0, 0);
  options->addWidget(new QualityPanel(this->Study, model));
  options->addWidget(new FitPanel(this->Study, model));
  this->AddSection("Model", model, false);
  this->AddSection("Touch", touch, true);
  auto* drill = new DrillPanel(this->Study, this->Questions, this);
  connect(structures, &StructuresPanel::SelectionChanged, drill,
          [structures, drill]
          {
            const std::vector<int> ids = structures->SelectedIds();
            drill->Choose(ids.empty() ? 0 : ids.front());
          });
  this->AddSection("Drilling", drill, false);
  auto* dock = new QDockWidget(this);
  dock->setObjectName("Work");
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
  dock->setTitleBarWidget(new QWidget(dock)); // none
  // The line is above what scrolls.
  auto* left = new QWidget(dock);
  auto* rows = new QVBoxLayout(left);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(new PipelineLine(this->Study, left));
  rows->addWidget(this->Column, 1);
  dock->setWidget(left);
  this->addDockWidget(Qt::LeftDockWidgetArea, dock);
  this->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  this->resizeDocks({dock}, {LeftWidth}, Qt::Horizontal);
}

QDockWidget* MainWindow::AddPanel(const QString& title, QWidget* panel)
{
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(title);
  dock->setWidget(panel);
  this->addDockWidget(Qt::BottomDockWidgetArea, dock);
  this->Panels->addAction(dock->toggleViewAction());
  dock->hide(); // until it is used
  return dock;
}

void MainWindow::MakePanels()
{
  this->MakeColumn();
  this->Panels->addSeparator();
  this->Marks = new LandmarksPanel(this->Study, this->Shown, this->Questions, this);
  QDockWidget* plots = this->AddPanel("Plots", new PlotsPanel(this->Study, this));
  QDockWidget* marks = this->AddPanel("Landmarks and measurements", this->Marks);
  this->AddMode(this->Marks->Tool(), marks);
  auto* relations = new RelationsPanel(this->Study, this->Shown, this->Questions, this);
  QDockWidget* related = this->AddPanel("Relations", relations);
  connect(relations, &RelationsPanel::Chosen, this, &MainWindow::LookAtPlace);
  this->tabifyDockWidget(plots, marks);
  this->tabifyDockWidget(marks, related);
  QDockWidget* last = related;
  for (QDockWidget* next :
       {this->MakeCheck(), this->MakeDrawing(), this->MakeCorrection(), this->MakeMatching()})
  {
    this->tabifyDockWidget(std::exchange(last, next), next);
  }
  this->resizeDocks({plots}, {BottomHeight}, Qt::Vertical);
  this->Touching->addActions({this->Marks->TouchTool(), this->Drawing->Mode(),
                              this->Drawing->TouchTool(), this->Correcting->Mode(),
                              this->Correcting->GripTool(), this->Matching->Mode(),
                              this->Matching->HoldTool()});
  this->Touching->addActions(this->Brushing->Actions());
  // In the views only: elsewhere these keys end an input.
  for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter})
  {
    auto* end = new QShortcut(key, this->Grid);
    end->setContext(Qt::WidgetWithChildrenShortcut);
    connect(end, &QShortcut::activated, this->Marks->EndTool(), &QAction::trigger);
  }
  auto* tools = new ToolRow(this->Study, this);
  tools->Add(this->Files->Tools());
  tools->Add(this->Viewing->Tools());
  tools->Add(this->Modes.All());
  tools->Add(this->Touching->Tools());
  this->addToolBar(tools);
}

QDockWidget* MainWindow::MakeCheck()
{
  auto* structures = this->findChild<StructuresPanel*>();
  auto* check = new CheckPanel(this->Study, structures->Verdicts(), this->Questions, this);
  QDockWidget* dock = this->AddPanel("Check structures", check);
  connect(structures, &StructuresPanel::CheckAsked, check,
          [dock, check]
          {
            dock->show();
            dock->raise();
            check->Check();
          });
  return dock;
}

QDockWidget* MainWindow::MakeDrawing()
{
  this->Drawing = new DrawingLink(
      this->Study, this->Shown, *this->Grid,
      [this] { return this->Marks->Placer()->TouchedPoint().PointWorld; }, this);
  this->Drawn = new DrawingPanel(this->Study, *this->Drawing, this->Questions, this);
  connect(this->Drawn, &DrawingPanel::Chosen, this, &MainWindow::LookAtPlace);
  return this->AddMode(this->Drawing->Mode(), this->AddPanel("Drawn organ", this->Drawn));
}

QDockWidget* MainWindow::MakeCorrection()
{
  this->Correcting = new CorrectionLink(
      this->Study, this->Shown, *this->Grid,
      [this] { return this->findChild<StructuresPanel*>()->SelectedIds(); },
      [this] { return this->Marks->Placer()->TouchedPoint().PointWorld; }, this);
  this->Brushing = new BrushLink(this->Study, this->Shown, *this->Grid, *this->Correcting, this);
  auto* panel = new CorrectionPanel(this->Study, *this->Correcting, *this->Brushing,
                                    this->Questions, this->Shown, this);
  return this->AddMode(this->Correcting->Mode(), this->AddPanel("Correction", panel));
}

QDockWidget* MainWindow::AddMode(QAction* mode, QDockWidget* dock)
{
  this->Modes.Add(mode);
  connect(mode, &QAction::toggled, dock,
          [this, dock](bool isOn)
          {
            if (isOn && !this->Quiet.IsQuiet())
            {
              dock->show();
              dock->raise();
            }
          });
  return dock;
}

QDockWidget* MainWindow::MakeMatching()
{
  this->Matching = new MatchingLink(this->Study, this->Shown, *this->Grid, this);
  auto* panel = new MatchingPanel(this->Study, this->Shown, *this->Matching, this->Questions, this);
  return this->AddMode(this->Matching->Mode(), this->AddPanel("Held organ", panel));
}

void MainWindow::MakeTasks(TouchLink& touch)
{
  this->Tasks = new TaskLink({this->Study, this->Questions, this->Shown, *this->Grid,
                              *this->Drawing, *this->Correcting, *this->Matching,
                              [&touch](bool isOn) { touch.ShowHandOnly(isOn); },
                              [this] { return this->Files->MayLeave(); }},
                             this->centralWidget());
  auto* column = qobject_cast<QVBoxLayout*>(this->centralWidget()->layout());
  column->insertWidget(0, this->Tasks->Strip());
  column->insertWidget(1, this->Tasks->Page(), 1);
  connect(this->Files, &FileMenu::TaskAsked, this->Tasks, &TaskLink::AskForTask);
  connect(this->Files, &FileMenu::ReadyTaskAsked, this->Tasks, &TaskLink::OpenReady);
  connect(&touch, &TouchLink::Escaped, this->Tasks,
          [this] { this->Tasks->Interrupt("Esc has switched force off."); });
  connect(this->Tasks, &TaskLink::Changed, this,
          [this]
          {
            this->Quiet.Set(this->Tasks->IsOpen());
            this->Study.HearTouches(this->Touching->Hearing()->isChecked() &&
                                    !this->Tasks->IsOpen());
            this->ShowCentre();
          });
}

void MainWindow::FollowModes()
{
  this->findChild<TouchLink*>()->LeaveClicks(this->Modes.IsAny());
  const bool areStrokes = this->Modes.IsAny() && !this->Marks->Tool()->isChecked();
  for (ViewPane* pane : this->Grid->Panes())
  {
    pane->SetStrokes(areStrokes);
  }
}

void MainWindow::LookAtPlace(const Vector3& place)
{
  this->Shown.Crosshair()->SetPositionWorld(place.data());
}

void MainWindow::ConnectViews()
{
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    SlicePane* slice = this->Grid->Slice(orientation);
    connect(slice, &SlicePane::PointedAt, this, &MainWindow::TakePointer);
    connect(slice, &SlicePane::PointerLeft, this->Status, &StatusLine::ClearPoint);
    connect(slice, &SlicePane::PointerLeft, this->Marks->Placer(), &MarkPlacer::ClearPreview);
    connect(slice, &SlicePane::ClickedAt, this, &MainWindow::TakeClick);
  }
  connect(this->Grid->Space(), &ViewPane::Clicked, this,
          [this](double x, double y)
          {
            Vector3 point;
            if (this->Marks->IsAdding() && this->Grid->Space()->View()->Pick(x, y, point.data()))
            {
              this->TakeClick(point);
            }
          });
  connect(this->Marks, &LandmarksPanel::Chosen, this, &MainWindow::LookAtPlace);
  this->Shown.Crosshair()->AddObserver(vtkCommand::ModifiedEvent, this, &MainWindow::TakeView);
  this->Shown.Images()->AddObserver(vtkCommand::ModifiedEvent, this, &MainWindow::TakeView);
  new StructureLink(
      *this->findChild<StructuresPanel*>(), this->Shown, *this->Grid,
      [this] { return !this->Modes.IsAny(); }, this);
  new VolumeRenderingLink(this->Study, this->Shown, *this->Grid->Space(), this);
  auto* link = new TouchLink(this->Study, this->Shown, *this->Grid, this);
  connect(this->Touching, &TouchMenu::WorkspaceShown, link, &TouchLink::ShowWorkspace);
  connect(this->Touching, &TouchMenu::WorkspaceMoved, link, &TouchLink::MoveWorkspace);
  this->Grid->Space()->PushAlongSight(this->Touching->PushAlongSight()->isChecked());
  connect(this->Touching->PushAlongSight(), &QAction::toggled, this->Grid->Space(),
          &SpacePane::PushAlongSight);
  connect(&this->Modes, &PointerModes::Changed, this, &MainWindow::FollowModes);
  connect(link, &TouchLink::Escaped, this,
          [this]
          {
            this->Modes.Leave();
            this->Touching->MoveWorkspace()->setChecked(false);
          });
  this->MakeTasks(*link);
  link->SoundAlarms(this->Touching->AlarmSound()->isChecked());
  connect(this->Touching->AlarmSound(), &QAction::toggled, link, &TouchLink::SoundAlarms);
}

void MainWindow::TakePointer(const Vector3& pointWorld)
{
  this->Status->ShowPoint(pointWorld, this->Shown.TextAt(pointWorld));
  if (this->Marks->IsAdding())
  {
    this->Marks->Placer()->Preview(pointWorld);
  }
}

void MainWindow::TakeClick(const Vector3& pointWorld)
{
  if (this->Marks->IsAdding())
  {
    this->Marks->Placer()->Place(pointWorld);
  }
}

void MainWindow::ShowState()
{
  {
    const QScopedValueRollback<bool> showing(this->IsShowing, true);
    this->Shown.ShowCorrection(this->Study.State(), this->Study.Current().Corrected());
    this->Shown.Show(this->Study.State(), this->Study.Current().Pipeline());
    this->Grid->TakeContents();
  }
  const StudyHistory& history = this->Study.Current().History();
  ShowStep(this->Undo, "&Undo", history.UndoText());
  ShowStep(this->Redo, "&Redo", history.RedoText());
  this->ShowCentre();
  this->ShowTitle();
}

// The views, or what can be opened while there is nothing to see.
void MainWindow::ShowCentre()
{
  const StudyState& state = this->Study.State();
  const bool isEmpty = state.VolumeFile.empty() && state.SegmentationFile.empty() &&
                       state.Structures.empty() && !state.Drawing.HasPlaces() &&
                       !this->Study.IsReplaying();
  if (isEmpty && !this->Start->isVisible())
  {
    this->Start->ShowRecent(RecentFiles());
  }
  const bool isTask = this->Tasks != nullptr && this->Tasks->IsOpen();
  const bool isResting = isTask && this->Tasks->IsResting();
  this->Start->setVisible(isEmpty && !isTask);
  this->Grid->setVisible(isTask ? !isResting : !isEmpty);
  if (isTask)
  {
    this->Tasks->Page()->setVisible(isResting);
  }
}

void MainWindow::ShowTitle()
{
  const std::filesystem::path& file = this->Study.Current().ProposedFile();
  QString name = file.empty() ? "New study" : TitleString(ScreenString(file.filename().string()));
  name += file == this->Study.Current().File() ? "" : " (recovered)";
  this->setWindowTitle(name + "[*] - Palpate");
  this->ShowChange();
}

void MainWindow::ShowChange()
{
  this->setWindowModified(this->Study.Current().IsChanged());
}

// The user's crosshair, window and level belong to the study.
void MainWindow::TakeView()
{
  if (!this->IsShowing && this->Shown.Images()->GetImage() != nullptr)
  {
    this->Study.ChangeView(this->Shown.WithViewOf(this->Study.State().View));
  }
}

void MainWindow::TakeFile(const QString& file)
{
  this->ShowTitle();
  if (file.endsWith(StudyEnding))
  {
    // Deferred: the answer changes the study that is being opened.
    QTimer::singleShot(0, this->Files, &FileMenu::AskForMissing);
  }
}

bool MainWindow::SaveScreenshot(const QString& file)
{
  bool isSaved = false;
  this->Study.Try(
      [&]
      {
        WritePicture(PictureOf(*this->Grid, *this), file.toStdString());
        isSaved = true;
      });
  return isSaved;
}

void MainWindow::AskForPicture()
{
  auto* dialog = new PictureDialog(*this->Grid, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this,
          [this, dialog]
          {
            QString file = this->Questions.ToSave(this, "Save the picture", dialog->ProposedName(),
                                                  "Images (*.png)");
            if (!file.isEmpty())
            {
              file += file.endsWith(".png", Qt::CaseInsensitive) ? "" : ".png";
              this->Study.Write(file.toStdString(),
                                [picture = dialog->Picture(), file](const ProgressFunction&)
                                { WritePicture(picture, file.toStdString()); });
            }
          });
  dialog->open();
}

void MainWindow::AskForPreferences()
{
  auto* dialog = new PreferencesDialog(*this->Keys, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PreferencesDialog::Changed, this, &MainWindow::Follow);
  dialog->open();
}

void MainWindow::Follow(const Preferences& preferences)
{
  QApplication::setPalette(PaletteOf(preferences.Look));
  if (preferences.LeftDragAdjustsWindow != this->Habits.LeftDragAdjustsWindow)
  {
    this->Viewing->AdjustWindowByLeftDrag(preferences.LeftDragAdjustsWindow);
  }
  this->Grid->SetNeurological(preferences.IsNeurological);
  this->Grid->SetLengthUnit(preferences.Unit);
  this->Shown.SetLengthUnit(preferences.Unit);
  this->Status->SetLengthUnit(preferences.Unit);
  this->Marks->SetLengthUnit(preferences.Unit);
  this->Drawn->SetLengthUnit(preferences.Unit);
  this->Study.BeginWith(preferences.NewStudy());
  this->Habits = preferences;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls())
  {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event)
{
  std::vector<std::filesystem::path> files;
  for (const QUrl& url : event->mimeData()->urls())
  {
    if (url.isLocalFile())
    {
      files.emplace_back(url.toLocalFile().toStdString());
    }
  }
  event->acceptProposedAction();
  this->Study.OpenFiles(files);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  this->Study.Current().Touch().SwitchForcesOff();
  this->EndEditing();
  // A task has nothing to save: its log is written.
  if (!this->Tasks->IsOpen() && !this->Files->MayLeave())
  {
    // Forces stay off until the user allows them again: they may have been off before.
    event->ignore();
    return;
  }
  this->Study.Close();
  event->accept();
}
} // namespace palpate
