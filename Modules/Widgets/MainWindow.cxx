#include "MainWindow.h"

#include "DrillPanel.h"
#include "HelpMenu.h"
#include "PipelinePanel.h"
#include "PlotsPanel.h"
#include "ReplayBar.h"
#include "ScreenString.h"
#include "StructuresPanel.h"
#include "TouchLink.h"
#include "TouchPanel.h"
#include "ViewMenu.h"
#include "WindowLook.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

namespace palpate
{
namespace
{
constexpr int LeftWidth = 280; // pixels
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
  QApplication::setPalette(PaletteOf(ChosenLook()));
  this->setAcceptDrops(true);
  this->setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  this->MakeCentre();
  this->MakeMenus();
  this->MakePanels();
  this->ConnectViews();
  connect(&study, &StudyController::StateChanged, this, &MainWindow::ShowState);
  connect(&study, &StudyController::ProductsChanged, this, &MainWindow::ShowState);
  connect(&study, &StudyController::FileOpened, this, &MainWindow::TakeFile);
  connect(&study, &StudyController::Problem, this->Area, &MessageArea::Add);
  this->ShowState();
}

void MainWindow::MakeCentre()
{
  auto* middle = new QWidget(this);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  this->Grid = new ViewGrid(this->Shown, middle);
  this->Area = new MessageArea(middle);
  column->addWidget(this->Grid, 1);
  column->addWidget(new ReplayBar(this->Study, middle));
  column->addWidget(this->Area);
  this->setCentralWidget(middle);
  this->Point = new QLabel(this);
  this->Point->setTextFormat(Qt::PlainText);
  this->statusBar()->addWidget(this->Point, 1);
}

void MainWindow::MakeMenus()
{
  this->Files = new FileMenu(this->Study, this->Questions, this->Shown, this);
  this->Study.AskBeforeLeaving([this] { return this->Files->MayLeave(); });
  this->Study.AskForSeries([this](const QStringList& series)
                           { return this->Questions.Series(this, series); });
  connect(this->Files, &FileMenu::ScreenshotAsked, this, &MainWindow::SaveScreenshot);
  this->menuBar()->addMenu(this->Files);
  QMenu* edit = this->menuBar()->addMenu("&Edit");
  this->Undo = edit->addAction("&Undo", &this->Study, &StudyController::Undo,
                               QKeySequence(QKeySequence::Undo));
  this->Redo = edit->addAction("&Redo", &this->Study, &StudyController::Redo,
                               QKeySequence(QKeySequence::Redo));
  this->menuBar()->addMenu(new ViewMenu(this->Study, *this->Grid, this->Shown, this));
  this->Touching = new TouchMenu(this->Study, this->Questions, this);
  this->menuBar()->addMenu(this->Touching);
  this->Panels = this->menuBar()->addMenu("&Panels");
  this->menuBar()->addMenu(new HelpMenu(this));
}

QDockWidget* MainWindow::AddPanel(const QString& title, QWidget* panel, Qt::DockWidgetArea area)
{
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(title);
  dock->setWidget(panel);
  this->addDockWidget(area, dock);
  this->Panels->addAction(dock->toggleViewAction());
  return dock;
}

void MainWindow::MakePanels()
{
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(LeftWidth);
  scroll->setWidget(new PipelinePanel(this->Study, scroll));
  this->Marks = new LandmarksPanel(this->Study, this->Questions, this);
  auto* structures = new StructuresPanel(this->Study, this);
  connect(structures, &StructuresPanel::OpacityChosen, this,
          [this](double opacity) { this->Shown.Images()->SetLabelOpacity(opacity); });
  QDockWidget* pipeline = this->AddPanel("Pipeline", scroll, Qt::LeftDockWidgetArea);
  auto* touchPanel = new TouchPanel(this->Study, this);
  connect(touchPanel, &TouchPanel::RecordAsked, this->Touching, &TouchMenu::ToggleRecording);
  touchPanel->AddTools({this->Touching->MoveWorkspace(), this->Touching->FitWorkspace()});
  QDockWidget* touch = this->AddPanel("Touch", touchPanel, Qt::LeftDockWidgetArea);
  QDockWidget* table = this->AddPanel("Structures", structures, Qt::BottomDockWidgetArea);
  QDockWidget* plots =
      this->AddPanel("Plots", new PlotsPanel(this->Study, this), Qt::BottomDockWidgetArea);
  QDockWidget* marks = this->AddPanel("Landmarks", this->Marks, Qt::BottomDockWidgetArea);
  this->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  this->tabifyDockWidget(table, plots);
  this->tabifyDockWidget(plots, marks);
  QDockWidget* drill = this->AddPanel(
      "Drilling", new DrillPanel(this->Study, this->Questions, this), Qt::BottomDockWidgetArea);
  this->tabifyDockWidget(marks, drill);
  drill->hide(); // until the user drills
  table->raise();
  this->resizeDocks({pipeline, touch}, {LeftWidth, LeftWidth}, Qt::Horizontal);
  this->resizeDocks({table}, {BottomHeight}, Qt::Vertical);
}

void MainWindow::ConnectViews()
{
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    SlicePane* slice = this->Grid->Slice(orientation);
    connect(slice, &SlicePane::PointedAt, this, &MainWindow::ShowPoint);
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
  connect(this->Marks, &LandmarksPanel::Chosen, this,
          [this](const Vector3& place)
          { this->Shown.Crosshair()->SetPositionWorld(place.data()); });
  this->Shown.Crosshair()->AddObserver(vtkCommand::ModifiedEvent, this, &MainWindow::TakeView);
  this->Shown.Images()->AddObserver(vtkCommand::ModifiedEvent, this, &MainWindow::TakeView);
  auto* link = new TouchLink(this->Study, this->Shown, *this->Grid, this);
  connect(this->Touching, &TouchMenu::WorkspaceShown, link, &TouchLink::ShowWorkspace);
  connect(this->Touching, &TouchMenu::WorkspaceMoved, link, &TouchLink::MoveWorkspace);
}

void MainWindow::TakeClick(const Vector3& pointWorld)
{
  if (this->Marks->IsAdding())
  {
    this->Marks->Add(pointWorld);
  }
}

void MainWindow::ShowState()
{
  {
    const QScopedValueRollback<bool> showing(this->IsShowing, true);
    this->Shown.Show(this->Study.State(), this->Study.Current().Pipeline());
    this->Grid->TakeContents();
  }
  const StudyHistory& history = this->Study.Current().History();
  ShowStep(this->Undo, "&Undo", history.UndoText());
  ShowStep(this->Redo, "&Redo", history.RedoText());
  this->ShowTitle();
}

void MainWindow::ShowTitle()
{
  const std::filesystem::path& file = this->Study.Current().File();
  const QString name =
      file.empty() ? "New study" : TitleString(ScreenString(file.filename().string()));
  this->setWindowTitle(name + "[*] - Palpate");
  this->setWindowModified(this->Study.Current().History().IsChanged());
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

void MainWindow::ShowPoint(const Vector3& pointWorld)
{
  const QString place = QString("L %1  P %2  S %3 mm")
                            .arg(pointWorld.x(), 0, 'f', 1)
                            .arg(pointWorld.y(), 0, 'f', 1)
                            .arg(pointWorld.z(), 0, 'f', 1);
  const std::string text = this->Shown.TextAt(pointWorld);
  this->Point->setText(text.empty() ? place : place + "   " + ScreenString(text));
}

bool MainWindow::SaveScreenshot(const QString& file)
{
  for (ViewPane* pane : this->Grid->Panes())
  {
    pane->RenderNow();
  }
  const bool isSaved = this->grab().save(file, "PNG");
  if (!isSaved)
  {
    this->Study.Report(file.toStdString() + ": the image cannot be written there");
  }
  return isSaved;
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
  if (!this->Files->MayLeave())
  {
    // Forces stay off until the user allows them again: they may have been off before.
    event->ignore();
    return;
  }
  this->Study.Close();
  event->accept();
}
} // namespace palpate
