#pragma once

#include "CohortColumns.h"
#include "CohortReading.h"
#include "CohortShapeView.h"
#include "FileQuestions.h"
#include "ScatterChart.h"

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QTemporaryDir>

#include <memory>
#include <vector>

namespace palpate
{
/// A cohort that `palpate fit` wrote, or of masks that are fitted here: a table of its cases with
/// pictures, the mean and its modes in 3-D with sliders, and any two columns as dots; a case that
/// is chosen in one is shown in all.
class CohortWindow : public QDialog
{
  Q_OBJECT

public:
  /// Keeps the address.
  CohortWindow(const FileQuestions& questions, QWidget* parent);

  /// Reads a folder with a cohort.csv in the background.
  void Open(const QString& folder);
  /// Asks for a folder of masks, fits them in the background, and shows the result.
  void FitMasks();
  /// The index of the chosen case, -1 for the mean and its modes.
  int Chosen() const { return this->ChosenCase; }

private:
  void AddButtons(QLayout* column);
  QWidget* MakeSliders();
  QPushButton* AddButton(QLayout* row, const QString& text, const QString& tip,
                         void (CohortWindow::*act)());
  void SetBusy(bool isBusy);
  void KeepModels();
  void Stop() { this->Reading.Stop(); }
  void ShowMean();
  void AskForFolder();
  void AskForCovariates();
  void Take(const std::shared_ptr<CohortReading::Product>& product);
  void Refuse(const QString& sentence);
  void FillTable();
  void FillChoices();
  void Choose(int index);
  void ShowModes();
  void ShowScatter();

  const FileQuestions& Questions;
  std::unique_ptr<QTemporaryDir> Fitted; ///< models that were fitted here; before what writes it
  bool IsFitted = false;                 ///< whether what is read or shown was
  CohortReading Reading;
  std::shared_ptr<CohortReading::Product> Product;
  std::unique_ptr<CovariateTable> Covariates;
  std::vector<CohortColumn> Columns;
  QTableWidget* Table;
  CohortShapeView* View;
  std::vector<QSlider*> Sliders;
  std::vector<QLabel*> SliderNames;
  QComboBox* Horizontal;
  QComboBox* Vertical;
  ScatterChart* Scatter;
  QPushButton* FitButton = nullptr;
  QPushButton* FolderButton = nullptr;
  QPushButton* CovariateButton = nullptr;
  QPushButton* MeanButton = nullptr;
  QPushButton* KeepButton = nullptr;
  QPushButton* CancelButton = nullptr;
  QProgressBar* Busy;
  QLabel* State;
  int ChosenCase = -1;
};
} // namespace palpate
