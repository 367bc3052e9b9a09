#include "DrawingPanel.h"

#include "CompletionFiles.h"
#include "KnownStructure.h"
#include "PlainLabel.h"
#include "Refusal.h"
#include "SceneTool.h"
#include "ScreenString.h"
#include "Segmentation.h"
#include "SidedLength.h"
#include "SoftwareVersions.h"
#include "TouchedPointsFile.h"
#include "Volume.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <memory>
#include <set>

namespace palpate
{
namespace
{
constexpr int LongestMessage = 170; // letters

QTableWidgetItem* TouchCell(const QString& text)
{
  auto* item = new QTableWidgetItem(text);
  item->setFlags(item->flags() & ~Qt::ItemIsEditable);
  return item;
}

QString KindOf(const StudyDrawing& drawing, std::size_t first)
{
  const SurfaceTouch& touch = drawing.Touches[first];
  if (touch.Stroke > 0)
  {
    const auto count =
        std::count_if(drawing.Touches.begin(), drawing.Touches.end(),
                      [&touch](const SurfaceTouch& one) { return one.Stroke == touch.Stroke; });
    return QString("Stroke of %1 points").arg(count);
  }
  return touch.IsOutside ? "Outside" : touch.Normal ? "Touch with its normal" : "Touch";
}

// For a job, while touches go on.
StartedCompletion CopyOf(const StartedCompletion& completion)
{
  return std::visit(
      [](const auto& one) -> StartedCompletion
      { return std::make_shared<typename std::decay_t<decltype(one)>::element_type>(*one); },
      completion);
}

// The image that was drawn on; null if there is none.
vtkSmartPointer<vtkImageData> GridOf(const StudyPipeline& pipeline)
{
  if (const auto volume = pipeline.Newest<Volume>(SceneStep::Volume))
  {
    return volume->Image;
  }
  const auto labels = pipeline.Newest<Segmentation>(SceneStep::Segmentation);
  return labels != nullptr ? labels->Layers.front() : vtkSmartPointer<vtkImageData>();
}
} // namespace

DrawingPanel::DrawingPanel(StudyController& study, DrawingLink& link,
                           const FileQuestions& questions, QWidget* parent)
    : QWidget(parent), Study(study), Link(link), Questions(questions),
      Table(new QTableWidget(0, 4, this)), Next(new QComboBox(this)),
      Prior(this->MakeButton({}, "draw-choose-prior", &DrawingPanel::ChoosePrior)),
      Known(new QComboBox(this)), Sigma(new QDoubleSpinBox(this)),
      Touchable(new QCheckBox("Can be felt", this)),
      Softened(new QCheckBox("Soft if unsure", this)),
      Contacts(new QCheckBox("Each contact", this)), Keeping(new QPushButton("Keep...", this)),
      Line(new SentenceLabel("draw-line", LongestMessage, this)),
      KeptLine(MakePlainLabel("draw-kept", this)),
      Job(new PanelJob(study, this->Keeping, this->KeptLine, this))
{
  this->Table->setObjectName("touches");
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->Table->verticalHeader()->hide();
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->MakeChoices();
  this->MakeKnown();
  this->MakeSoftened();
  auto* row = new QHBoxLayout;
  row->addWidget(this->Table, 1);
  row->addWidget(this->MakeButtons());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 2, 4, 2);
  column->setSpacing(2);
  column->addWidget(this->Line);
  column->addWidget(this->KeptLine);
  column->addLayout(row, 1);
  connect(this->Table, &QTableWidget::cellDoubleClicked, this,
          [this](int chosen)
          {
            const StudyDrawing& drawing = this->Study.State().Drawing;
            Q_EMIT Chosen(
                drawing.Touches.at(this->Rows.at(static_cast<std::size_t>(chosen))).PointWorld);
          });
  connect(this->Job, &PanelJob::Asked, this, &DrawingPanel::Keep);
  connect(this->Job, &PanelJob::Changed, this,
          [this] { this->KeptLine->setVisible(!this->KeptLine->text().isEmpty()); });
  this->Job->End({});
  connect(&study, &StudyController::StateChanged, this, &DrawingPanel::ShowState);
  this->ShowState();
}

void DrawingPanel::MakeSoftened()
{
  this->Softened->setObjectName("draw-softened");
  this->Softened->setToolTip(
      "Whether the drawn organ is felt softer where its surface is less sure: "
      "a push of 1 N goes one standard deviation deeper");
  connect(this->Softened, &QCheckBox::clicked, this,
          [this](bool isOn)
          {
            StudyDrawing drawing = this->Study.State().Drawing;
            drawing.IsSoftened = isOn;
            this->Change(isOn ? "Feel the drawn organ softer where unsure"
                              : "Feel the drawn organ evenly",
                         drawing);
          });
}

void DrawingPanel::MakeKnown()
{
  this->Known->setObjectName("draw-known");
  this->Known->setAccessibleName("The known organ");
  this->Known->setToolTip("The organ that this prior relates to, a label or a model: it says much "
                          "of the other one, before any touch");
  this->Known->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Known->setMinimumContentsLength(16);
  connect(this->Known, QOverload<int>::of(&QComboBox::activated), this, &DrawingPanel::SetKnown);
}

void DrawingPanel::MakeChoices()
{
  this->Next->setObjectName("draw-next");
  this->Next->addItems({"On the surface", "Outside here", "The middle"});
  this->Next->setAccessibleName("What a click is");
  this->Next->setToolTip("What a click in a view is: a touch of the organ (a drag on a slice is a "
                         "stroke), a point that the organ does not reach (also with Ctrl), or the "
                         "organ's middle");
  connect(this->Next, QOverload<int>::of(&QComboBox::activated), this,
          [this](int chosen)
          { this->Link.Choose(DrawingLink::AllNext.at(static_cast<std::size_t>(chosen))); });
  connect(&this->Link, &DrawingLink::ChoiceChanged, this,
          [this] { this->Next->setCurrentIndex(static_cast<int>(this->Link.Chosen())); });
  this->Sigma->setObjectName("draw-sigma");
  this->Sigma->setRange(LeastTouchDeviation, LargestTouchDeviation);
  this->Sigma->setDecimals(2);
  this->Sigma->setSingleStep(0.1);
  this->Sigma->setPrefix("\u00b1 ");
  this->Sigma->setSuffix(" mm");
  this->Sigma->setToolTip("How far a touch typically is from the true surface");
  connect(this->Sigma, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double sigma)
          {
            StudyDrawing drawing = this->Study.State().Drawing;
            SetSigma(drawing, sigma);
            this->Change("Change the touches' standard deviation", drawing, "sigma");
          });
  this->Touchable->setObjectName("draw-touchable");
  this->Touchable->setToolTip("Whether the tool feels the organ as it is drawn so far; off, it "
                              "reaches what is below");
  connect(this->Touchable, &QCheckBox::clicked, this,
          [this](bool isOn)
          {
            StudyDrawing drawing = this->Study.State().Drawing;
            drawing.IsTouchable = isOn;
            this->Change(isOn ? "Feel the drawn organ" : "Do not feel the drawn organ", drawing);
          });
  this->Contacts->setObjectName("draw-contacts");
  this->Contacts->setChecked(true);
  this->Contacts->setToolTip("Whether each contact of the tool that lasts is a touch of the organ; "
                             "off, only Draw where touched (Shift+T) is");
  connect(this->Contacts, &QCheckBox::toggled, &this->Link, &DrawingLink::TakeContacts);
}

QPushButton* DrawingPanel::MakeButton(const QString& text, const char* name,
                                      void (DrawingPanel::*act)())
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(name);
  connect(button, &QPushButton::clicked, this, act);
  return button;
}

QWidget* DrawingPanel::MakeButtons()
{
  auto* mode = new QPushButton("Draw (T)", this);
  mode->setObjectName("draw-mode");
  mode->setCheckable(true);
  connect(mode, &QPushButton::toggled, this->Link.Mode(), &QAction::setChecked);
  connect(this->Link.Mode(), &QAction::toggled, mode, &QPushButton::setChecked);
  this->Keeping->setObjectName("draw-keep");
  this->Keeping->setToolTip("Writes model, mask and standard deviations to a folder, and makes the "
                            "organ a structure of that name");
  auto* buttons = new QWidget(this);
  auto* grid = new QGridLayout(buttons);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2);
  grid->addWidget(mode, 0, 0);
  grid->addWidget(this->Next, 0, 1);
  grid->addWidget(this->Sigma, 0, 2);
  grid->addWidget(this->Prior, 1, 0, 1, 2);
  grid->addWidget(this->Touchable, 1, 2);
  grid->addWidget(this->MakeButton("Remove", "draw-remove", &DrawingPanel::Remove), 2, 0);
  grid->addWidget(this->MakeButton("Clear", "draw-clear", &DrawingPanel::Clear), 2, 1);
  grid->addWidget(this->Contacts, 2, 2);
  grid->addWidget(this->MakeButton("Import...", "draw-import", &DrawingPanel::Import), 3, 0);
  grid->addWidget(this->MakeButton("Export...", "draw-export", &DrawingPanel::Export), 3, 1);
  grid->addWidget(this->Keeping, 3, 2);
  grid->addWidget(this->Known, 4, 0, 1, 2);
  grid->addWidget(this->Softened, 4, 2);
  grid->setRowStretch(grid->rowCount(), 1);
  return buttons;
}

void DrawingPanel::SetLengthUnit(LengthUnit unit)
{
  this->Unit = unit;
  this->ShowState();
}

void DrawingPanel::ShowState()
{
  const StudyDrawing& drawing = this->Study.State().Drawing;
  const QSignalBlocker quiet(this->Sigma);
  this->Sigma->setValue(drawing.Sigma);
  this->Touchable->setChecked(drawing.IsTouchable);
  this->Softened->setChecked(drawing.IsSoftened);
  this->Softened->setEnabled(drawing.IsTouchable);
  this->ShowTouches();
  this->ShowPrior();
  this->ShowKnown();
  this->Line->Say(this->Sentence());
  const DrawnOrgan& organ = this->Study.Current().Drawn().Organ();
  this->Keeping->setEnabled(this->Job->IsRunning() ||
                            (organ.Surface() != nullptr && organ.Refusal().empty()));
}

void DrawingPanel::ShowTouches()
{
  QStringList heads{"Kind"};
  for (const char* axis : {"R, L", "A, P", "I, S"})
  {
    heads += QString("%1 (%2)").arg(axis, SymbolOf(this->Unit));
  }
  this->Table->setHorizontalHeaderLabels(heads);
  const StudyDrawing& drawing = this->Study.State().Drawing;
  const std::size_t before = this->Rows.size();
  this->Rows.clear();
  for (std::size_t n = 0; n < drawing.Touches.size(); ++n)
  {
    const int stroke = drawing.Touches[n].Stroke;
    if (stroke == 0 || n == 0 || drawing.Touches[n - 1].Stroke != stroke)
    {
      this->Rows.push_back(n);
    }
  }
  this->Table->setRowCount(static_cast<int>(this->Rows.size()));
  for (std::size_t r = 0; r < this->Rows.size(); ++r)
  {
    const int row = static_cast<int>(r);
    this->Table->setItem(row, 0, TouchCell(KindOf(drawing, this->Rows[r])));
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3& place = drawing.Touches[this->Rows[r]].PointWorld;
      this->Table->setItem(row, 1 + axis, TouchCell(SidedLength(place, axis, this->Unit, 1)));
    }
  }
  if (this->Rows.size() > before)
  {
    this->Table->doItemsLayout(); // otherwise it has no place to scroll to yet
    this->Table->scrollToBottom();
  }
}

void DrawingPanel::ShowPrior()
{
  const std::filesystem::path& file = this->Study.State().Drawing.PriorFile;
  const auto cases = this->Study.Current().Drawn().PriorCases();
  QString text = file.empty() ? "none, smooth" : ScreenString(file.filename().string());
  text += cases ? QString(", %1 cases").arg(*cases) : QString();
  const int width = 22 * this->fontMetrics().averageCharWidth();
  this->Prior->setText(
      MenuString("Prior: " + this->fontMetrics().elidedText(text, Qt::ElideMiddle, width)));
  this->Prior->setToolTip(
      file.empty() ? "What a group of such organs looks like, as palpate cohort --prior writes it; "
                     "none: organs are smooth"
                   : PlainToolTip(QString::fromStdString(file.string()) + "\nNone again"));
}

void DrawingPanel::ShowKnown()
{
  const StudyDrawn& drawn = this->Study.Current().Drawn();
  const QSignalBlocker quiet(this->Known);
  this->Known->setVisible(drawn.Relation() != nullptr);
  this->Known->clear();
  this->Known->addItem("No known organ", 0);
  for (const SceneStructure& structure : this->Study.State().Structures)
  {
    if (CanBeKnown(structure))
    {
      this->Known->addItem("Known: " + ScreenString(TitleOf(structure)), structure.Id);
    }
  }
  const bool hasKnown = drawn.Known() != nullptr;
  this->Known->setCurrentIndex(hasKnown ? this->Known->findData(drawn.Known()->Id) : 0);
  if (hasKnown && !this->HadKnown && this->Link.Chosen() == DrawingLink::Next::Center)
  {
    this->Link.Choose(DrawingLink::Next::Surface); // it says where the middle is
  }
  this->HadKnown = hasKnown;
}

QString DrawingPanel::Sentence() const
{
  const StudyDrawn& drawn = this->Study.Current().Drawn();
  if (drawn.IsReadingPrior())
  {
    return "Reading the prior...";
  }
  if (drawn.IsReadingKnown())
  {
    return "Measuring the known organ...";
  }
  return this->SentenceOfProblems() + this->SentenceOfOrgan();
}

QString DrawingPanel::SentenceOfProblems() const
{
  const StudyDrawn& drawn = this->Study.Current().Drawn();
  QString problems;
  if (!drawn.PriorProblem().empty())
  {
    problems += ScreenString(drawn.PriorProblem()) + " Organs are taken as smooth instead. ";
  }
  if (!drawn.KnownProblem().empty())
  {
    problems += ScreenString(drawn.KnownProblem()) + ": it is left out. ";
  }
  return problems;
}

QString DrawingPanel::SentenceOfOrgan() const
{
  const StudyDrawn& drawn = this->Study.Current().Drawn();
  const DrawnOrgan& organ = drawn.Organ();
  if (!organ.Refusal().empty())
  {
    return "Refused: " + ScreenString(organ.Refusal()) + ".";
  }
  if (organ.Completion() == nullptr)
  {
    const std::size_t count = SurfaceCount(this->Study.State().Drawing);
    if (drawn.Relation() != nullptr && drawn.Known() == nullptr && count == 0)
    {
      return "Choose the known organ that this prior relates to, or click near the other one's "
             "middle (choose The middle).";
    }
    return drawn.HasPrior() && count == 0
               ? QString("Click near the organ's middle (choose The middle): its most probable "
                         "surface is shown, and where to touch it first.")
               : QString("Touch the organ: click its edge in a slice or draw along it, or touch it "
                         "with the tool. Its most probable surface is shown from the third touch "
                         "on (%1 so far).")
                     .arg(count);
  }
  const QString numbers = QString("%1 ml, sure to %2 mm or better (one standard deviation)")
                              .arg(organ.Milliliters(), 0, 'f', 1)
                              .arg(organ.LargestDeviation(), 0, 'f', 1);
  const std::size_t number = organ.TouchCount() + 1;
  return organ.Next().empty()
             ? numbers + ". Touch next where the outline leaves the image's edge most."
             : numbers + QString(". Touch next where the mark %1 is.").arg(number);
}

void DrawingPanel::Change(const QString& message, const StudyDrawing& drawing,
                          const QString& gesture)
{
  StudyState next = this->Study.State();
  next.Drawing = drawing;
  this->Study.Change(message, next, gesture);
}

void DrawingPanel::ChoosePrior()
{
  if (!this->Study.State().Drawing.PriorFile.empty())
  {
    this->SetPrior({});
    return;
  }
  const QStringList files = this->Questions.ToOpen(this, "Prior of an organ", "Priors (*.json)");
  if (!files.isEmpty())
  {
    this->SetPrior(files.front().toStdString());
  }
}

void DrawingPanel::SetPrior(const std::filesystem::path& file)
{
  StudyDrawing drawing = this->Study.State().Drawing;
  drawing.PriorFile = StudyPath(file);
  if (!file.empty() && !drawing.HasPlaces())
  {
    this->Link.Choose(DrawingLink::Next::Center); // unless it turns out to know another organ
  }
  this->Change(file.empty() ? "Take organs as smooth" : "Change the prior", drawing);
}

void DrawingPanel::SetKnown(int row)
{
  StudyDrawing drawing = this->Study.State().Drawing;
  drawing.KnownId = this->Known->itemData(row).toInt();
  this->Change(drawing.KnownId != 0 ? "Change the known organ" : "Draw without a known organ",
               drawing);
}

void DrawingPanel::Remove()
{
  std::set<std::size_t, std::greater<>> chosen; // the last first, since numbers change behind them
  for (const QTableWidgetItem* item : this->Table->selectedItems())
  {
    chosen.insert(this->Rows.at(static_cast<std::size_t>(item->row())));
  }
  StudyDrawing drawing = this->Study.State().Drawing;
  for (const std::size_t number : chosen)
  {
    RemoveTouch(drawing, number);
  }
  this->Change("Remove touches", drawing);
}

void DrawingPanel::Clear()
{
  StudyDrawing drawing = this->Study.State().Drawing;
  drawing.Touches.clear();
  drawing.CenterWorld.reset();
  this->Change("Remove all touches", drawing);
}

void DrawingPanel::Import()
{
  const QStringList files =
      this->Questions.ToOpen(this, "Import touches", "Touches (*.csv *.mrk.json *.fcsv *.touch)");
  this->Study.Try(
      [&]
      {
        StudyDrawing drawing = this->Study.State().Drawing;
        for (const QString& file : files)
        {
          const double radius = MakeTool(this->Study.State().Tool).BoundingRadius();
          RequireInput(
              AddTouches(drawing, ReadTouchedPoints(file.toStdString(), drawing.Sigma, radius)));
        }
        this->Change("Import touches", drawing);
      });
}

void DrawingPanel::Export()
{
  const QString file = this->Questions.ToSave(this, "Export touches", "touches.csv",
                                              "Table (*.csv);;3D Slicer markups (*.mrk.json)");
  if (!file.isEmpty())
  {
    const std::filesystem::path path = file.toStdString();
    this->Study.Write(path, [path, touches = this->Study.State().Drawing.Touches](
                                const ProgressFunction&) { WriteTouchedPoints(path, touches); });
  }
}

void DrawingPanel::Keep()
{
  const StudyDrawn& drawn = this->Study.Current().Drawn();
  const StartedCompletion* completion = drawn.Organ().Completion();
  const QString chosen = completion != nullptr
                             ? this->Questions.Folder(this, "Folder for the organ, and its name")
                             : QString();
  if (chosen.isEmpty())
  {
    return;
  }
  const std::filesystem::path folder = StudyPath(chosen.toStdString());
  const std::string name = folder.filename().string();
  CompletionInputs inputs;
  inputs.Prior = this->Study.State().Drawing.PriorFile;
  inputs.Known = drawn.Known() != nullptr ? drawn.Known()->File : std::filesystem::path();
  inputs.Sigma = this->Study.State().Drawing.Sigma;
  inputs.Grid = GridOf(this->Study.Current().Pipeline());
  this->Job->Run(
      [this, copy = CopyOf(*completion), inputs, folder, name,
       drawing = this->Study.State().Drawing](const ProgressFunction&)
      {
        WriteCompletionFiles(
            CompletedOrgan::Of(DescribeCompletion(copy, CompletedOrgan::Frequency, 0),
                               drawing.Touches.size()),
            inputs, folder, "palpate-viewer " + SoftwareVersions().front().second);
        return [this, folder, name, drawing]
        {
          StudyState next = WithKeptOrgan(this->Study.State(), name, folder / "model.json");
          const StudyDrawing& now = this->Study.State().Drawing;
          next.Drawing = now == drawing ? next.Drawing : now; // it went on meanwhile
          this->Study.Change("Keep " + ScreenString(name), next);
          this->Job->End("Kept in " + ScreenString(folder.string()) + ".");
        };
      });
}
} // namespace palpate
