#include "CohortWindow.h"

#include "CohortPage.h"
#include "CovariateFile.h"
#include "DecimalText.h"
#include "InputError.h"
#include "ScreenString.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include <cmath>
#include <filesystem>

namespace palpate
{
namespace
{
constexpr int SliderSteps = 10; // per standard deviation
constexpr int MostDeviations = 3;
constexpr int RowHeight = 52; // pixels, of a picture

// Sorted as a number, shown with few digits.
class NumberItem : public QTableWidgetItem
{
public:
  explicit NumberItem(double value)
      : QTableWidgetItem(std::isfinite(value) ? QString::fromStdString(SignificantText(value, 4))
                                              : QString()),
        Value(value)
  {
    this->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  bool operator<(const QTableWidgetItem& other) const override
  {
    const auto* number = dynamic_cast<const NumberItem*>(&other);
    return number != nullptr ? this->Value < number->Value : QTableWidgetItem::operator<(other);
  }

private:
  double Value;
};
} // namespace

CohortWindow::CohortWindow(const FileQuestions& questions, QWidget* parent)
    : QDialog(parent), Questions(questions), Table(new QTableWidget(this)),
      View(new CohortShapeView(this)), Horizontal(new QComboBox(this)),
      Vertical(new QComboBox(this)), Scatter(new ScatterChart(this)), Busy(new QProgressBar(this)),
      State(new QLabel(this))
{
  this->setWindowTitle("Cohort");
  this->setObjectName("cohort-window");
  auto* column = new QVBoxLayout(this);
  this->AddButtons(column);
  auto* right = new QWidget(this);
  auto* stack = new QVBoxLayout(right);
  stack->setContentsMargins(0, 0, 0, 0);
  stack->addWidget(this->View, 3);
  stack->addWidget(this->MakeSliders());
  auto* axes = new QHBoxLayout;
  axes->addWidget(new QLabel("Across", this));
  axes->addWidget(this->Horizontal, 1);
  axes->addWidget(new QLabel("Up", this));
  axes->addWidget(this->Vertical, 1);
  stack->addLayout(axes);
  stack->addWidget(this->Scatter, 2);
  auto* halves = new QSplitter(this);
  halves->addWidget(this->Table);
  halves->addWidget(right);
  halves->setChildrenCollapsible(false);
  column->addWidget(halves, 1);
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->verticalHeader()->hide();
  this->Table->setIconSize({48, 48});
  connect(this->Table, &QTableWidget::itemSelectionChanged, this,
          [this]
          {
            const QList<QTableWidgetItem*> items = this->Table->selectedItems();
            this->Choose(
                items.isEmpty()
                    ? -1
                    : this->Table->item(items.front()->row(), 0)->data(Qt::UserRole).toInt());
          });
  connect(this->Scatter, &ScatterChart::Clicked, this, &CohortWindow::Choose);
  for (QComboBox* choice : {this->Horizontal, this->Vertical})
  {
    connect(choice, qOverload<int>(&QComboBox::currentIndexChanged), this,
            &CohortWindow::ShowScatter);
  }
  connect(&this->Reading, &CohortReading::Done, this, &CohortWindow::Take);
  connect(&this->Reading, &CohortReading::Failed, this, &CohortWindow::Refuse);
  connect(&this->Reading, &CohortReading::Progressed, this->Busy, &QProgressBar::setValue);
  connect(&this->Reading, &CohortReading::Stopped, this, [this] { this->Refuse("Cancelled."); });
  connect(&this->Reading, &CohortReading::StageReached, this,
          [this](const QString& stage)
          { this->State->setText("Fitting mask " + ScreenString(stage.toStdString())); });
  this->resize(1000, 700);
}

QPushButton* CohortWindow::AddButton(QLayout* row, const QString& text, const QString& tip,
                                     void (CohortWindow::*act)())
{
  auto* button = new QPushButton(text, this);
  button->setToolTip(tip);
  button->setAutoDefault(false);
  row->addWidget(button);
  connect(button, &QPushButton::clicked, this, act);
  return button;
}

void CohortWindow::AddButtons(QLayout* column)
{
  auto* row = new QHBoxLayout;
  this->FitButton = this->AddButton(row, "Fit &masks...", "Fits a folder with a mask for each case",
                                    &CohortWindow::FitMasks);
  this->FolderButton = this->AddButton(row, "Open &folder...", "A folder with a cohort.csv",
                                       &CohortWindow::AskForFolder);
  this->CovariateButton = this->AddButton(
      row, "Add &covariates...", "A table with a row per case (CSV), for the columns and the dots",
      &CohortWindow::AskForCovariates);
  this->MeanButton = this->AddButton(
      row, "Show &mean", "The mean, moved along the modes by the sliders", &CohortWindow::ShowMean);
  this->KeepButton =
      this->AddButton(row, "&Keep models...", "Copies the models and their table into a folder",
                      &CohortWindow::KeepModels);
  row->addWidget(this->State, 1);
  row->addWidget(this->Busy);
  this->CancelButton = this->AddButton(row, "Cancel", "Ends the work", &CohortWindow::Stop);
  static_cast<QVBoxLayout*>(column)->addLayout(row);
  this->State->setObjectName("cohort-state");
  this->State->setTextFormat(Qt::PlainText);
  this->State->setWordWrap(true);
  this->State->setText("Fit a folder of masks, or open a folder that `palpate fit` wrote.");
  this->Busy->setRange(0, 100);
  this->Busy->setMaximumWidth(120);
  this->CancelButton->setObjectName("cohort-cancel");
  this->KeepButton->hide();
  this->CovariateButton->setEnabled(false);
  this->MeanButton->setEnabled(false);
  this->SetBusy(false);
}

void CohortWindow::SetBusy(bool isBusy)
{
  if (isBusy)
  {
    this->Busy->setValue(0);
  }
  this->Busy->setVisible(isBusy);
  this->CancelButton->setVisible(isBusy);
  this->FitButton->setEnabled(!isBusy);
  this->FolderButton->setEnabled(!isBusy);
}

void CohortWindow::ShowMean()
{
  for (QSlider* slider : this->Sliders)
  {
    const QSignalBlocker quiet(slider);
    slider->setValue(0);
  }
  this->Choose(-1);
}

QWidget* CohortWindow::MakeSliders()
{
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  for (int mode = 0; mode < MostShownModes; ++mode)
  {
    auto* name = new QLabel(QString("Mode %1").arg(mode + 1), box);
    auto* slider = new QSlider(Qt::Horizontal, box);
    slider->setRange(-MostDeviations * SliderSteps, MostDeviations * SliderSteps);
    slider->setObjectName(QString("cohort-mode-%1").arg(mode + 1));
    slider->setToolTip("Standard deviations, from -3 to 3");
    slider->setEnabled(false);
    grid->addWidget(name, mode, 0);
    grid->addWidget(slider, mode, 1);
    connect(slider, &QSlider::valueChanged, this, &CohortWindow::ShowModes);
    this->Sliders.push_back(slider);
    this->SliderNames.push_back(name);
  }
  return box;
}

void CohortWindow::AskForFolder()
{
  const QString folder = this->Questions.Folder(this, "Open a cohort");
  if (!folder.isEmpty())
  {
    this->Open(folder);
  }
}

void CohortWindow::Open(const QString& folder)
{
  this->State->setText("Reading " + ScreenString(folder.toStdString()) + "...");
  this->SetBusy(true);
  this->KeepButton->hide();
  this->IsFitted = false;
  this->Reading.Start(folder);
}

void CohortWindow::FitMasks()
{
  const QString masks = this->Questions.Folder(this, "Choose a folder of masks");
  if (masks.isEmpty())
  {
    return;
  }
  this->State->setText("Fitting " + ScreenString(masks.toStdString()) + "...");
  this->SetBusy(true);
  this->KeepButton->hide();
  this->Reading.Cancel(); // before what it may write is removed
  this->IsFitted = true;
  this->Fitted = std::make_unique<QTemporaryDir>();
  this->Reading.StartFit(masks, this->Fitted->path());
}

void CohortWindow::KeepModels()
{
  const QString folder = this->Questions.Folder(this, "Keep the models in a folder");
  if (folder.isEmpty())
  {
    return;
  }
  std::error_code failure;
  std::filesystem::copy(this->Fitted->path().toStdString(), folder.toStdString(),
                        std::filesystem::copy_options::recursive, failure);
  this->State->setText(failure ? ScreenString("The models were not copied into " +
                                              folder.toStdString() + ": " + failure.message())
                               : "Kept in " + ScreenString(folder.toStdString()));
}

void CohortWindow::Refuse(const QString& sentence)
{
  this->SetBusy(false);
  this->State->setText(ScreenString(sentence.toStdString()));
}

void CohortWindow::Take(const std::shared_ptr<CohortReading::Product>& product)
{
  this->SetBusy(false);
  this->KeepButton->setVisible(this->IsFitted);
  this->View->SetGroup(nullptr);
  this->Product = product;
  this->Covariates.reset();
  const CohortGroup& group = product->Group;
  this->View->SetGroup(&group);
  this->State->setText(
      QString("%1 cases, degree %2%3")
          .arg(group.Rows.size())
          .arg(DegreeOf(group.Models.front()))
          .arg(group.Notes.empty() ? QString() : QString("; %1 notes").arg(group.Notes.size())));
  QStringList notes;
  for (const CohortNote& note : group.Notes)
  {
    notes << ScreenString(note.Case + note.Text + note.Reason);
  }
  this->State->setToolTip(notes.join("\n"));
  for (int mode = 0; mode < MostShownModes; ++mode)
  {
    const bool isThere = mode < ShownModes(group);
    const auto k = static_cast<std::size_t>(mode);
    this->Sliders[k]->setEnabled(isThere);
    this->SliderNames[k]->setText(isThere ? QString("Mode %1, %2 %")
                                                .arg(mode + 1)
                                                .arg(100.0 * group.Modes.Explained[mode], 0, 'f', 1)
                                          : QString("Mode %1").arg(mode + 1));
  }
  this->CovariateButton->setEnabled(true);
  this->MeanButton->setEnabled(true);
  this->Columns = ColumnsOf(group, nullptr);
  this->FillTable();
  this->FillChoices();
  this->ShowMean();
}

void CohortWindow::AskForCovariates()
{
  const QStringList files =
      this->Questions.ToOpen(this, "Add covariates", "Tables (*.csv);;All files (*)");
  if (files.isEmpty())
  {
    return;
  }
  std::vector<std::string> cases;
  for (const CohortRow& row : this->Product->Group.Rows)
  {
    cases.push_back(row.Case);
  }
  try
  {
    std::vector<std::string> notes;
    this->Covariates = std::make_unique<CovariateTable>(
        ReadCovariates(files.front().toStdString(), "", cases, notes));
    this->Columns = ColumnsOf(this->Product->Group, this->Covariates.get());
    this->FillTable();
    this->FillChoices();
    this->Choose(this->ChosenCase);
    this->State->setText(notes.empty()
                             ? QString("%1 covariates").arg(this->Covariates->Columns().size())
                             : ScreenString(notes.front()));
  }
  catch (const InputError& error)
  {
    this->State->setText(ScreenString(error.what()));
  }
}

void CohortWindow::FillTable()
{
  const QSignalBlocker quiet(this->Table);
  const CohortGroup& group = this->Product->Group;
  const auto rows = static_cast<int>(group.Rows.size());
  QStringList head{"Case"};
  for (const CohortColumn& column : this->Columns)
  {
    head << column.Name;
  }
  this->Table->setSortingEnabled(false);
  this->Table->clear();
  this->Table->setRowCount(rows);
  this->Table->setColumnCount(static_cast<int>(head.size()));
  this->Table->setHorizontalHeaderLabels(head);
  for (int row = 0; row < rows; ++row)
  {
    const auto i = static_cast<std::size_t>(row);
    auto* name = new QTableWidgetItem(QIcon(QPixmap::fromImage(this->Product->Pictures[i])),
                                      ScreenString(group.Rows[i].Case));
    name->setData(Qt::UserRole, row);
    this->Table->setItem(row, 0, name);
    this->Table->setRowHeight(row, RowHeight);
    for (std::size_t k = 0; k < this->Columns.size(); ++k)
    {
      const Covariate* words = nullptr;
      if (this->Covariates != nullptr)
      {
        words = this->Covariates->Find(this->Columns[k].Name.toStdString());
      }
      auto* item = words != nullptr && !words->IsNumeric()
                       ? new QTableWidgetItem(ScreenString(words->Texts()[i]))
                       : new NumberItem(this->Columns[k].Values[i]);
      this->Table->setItem(row, static_cast<int>(k) + 1, item);
    }
  }
  this->Table->setSortingEnabled(true);
  this->Table->resizeColumnsToContents();
}

void CohortWindow::FillChoices()
{
  for (QComboBox* choice : {this->Horizontal, this->Vertical})
  {
    const QSignalBlocker quiet(choice);
    const QString former = choice->currentText();
    choice->clear();
    for (const CohortColumn& column : this->Columns)
    {
      choice->addItem(column.Name);
    }
    const int place = choice->findText(former);
    const int first = choice == this->Horizontal ? 0 : std::min(choice->count() - 1, 2);
    choice->setCurrentIndex(place >= 0 ? place : first);
  }
  this->ShowScatter();
}

void CohortWindow::Choose(int index)
{
  this->ChosenCase = index;
  this->Scatter->Choose(index);
  const QSignalBlocker quiet(this->Table);
  this->Table->clearSelection();
  for (int row = 0; row < this->Table->rowCount() && index >= 0; ++row)
  {
    if (this->Table->item(row, 0)->data(Qt::UserRole).toInt() == index)
    {
      this->Table->selectRow(row);
      this->Table->scrollToItem(this->Table->item(row, 0));
    }
  }
  if (index >= 0)
  {
    this->View->ShowCase(static_cast<std::size_t>(index));
  }
  else
  {
    this->ShowModes();
  }
}

void CohortWindow::ShowModes()
{
  if (this->Product == nullptr)
  {
    return;
  }
  if (this->ChosenCase >= 0)
  {
    this->Choose(-1);
    return;
  }
  std::vector<double> deviations;
  for (const QSlider* slider : this->Sliders)
  {
    deviations.push_back(static_cast<double>(slider->value()) / SliderSteps);
  }
  this->View->ShowModes(deviations);
}

void CohortWindow::ShowScatter()
{
  const int x = this->Horizontal->currentIndex();
  const int y = this->Vertical->currentIndex();
  if (x >= 0 && y >= 0)
  {
    const CohortColumn& across = this->Columns[static_cast<std::size_t>(x)];
    const CohortColumn& up = this->Columns[static_cast<std::size_t>(y)];
    this->Scatter->SetPoints(across.Name, up.Name, across.Values, up.Values);
  }
}
} // namespace palpate
