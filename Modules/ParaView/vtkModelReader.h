#ifndef vtkModelReader_h
#define vtkModelReader_h

#include "PalpateParaViewModule.h"
#include "vtkPolyDataAlgorithm.h"

/// Reads a model (palpate::ReadModel: Palpate's JSON or SPHARM-PDM's .coef) and triangulates it:
/// mm, patient LPS, with analytic normals. Field arrays "Degree" and "Center" (mm). A file that is
/// no model raises an error and produces no output.
class PALPATEPARAVIEW_EXPORT vtkModelReader : public vtkPolyDataAlgorithm
{
public:
  static vtkModelReader* New();
  vtkTypeMacro(vtkModelReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ The file.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// Whether the file holds a model: JSON files are of many kinds.
  static int CanReadFile(const char* name);

  ///@{ Number of parts into which each edge of the icosahedron is divided, at least; a model of
  /// many
  /// degrees is drawn finer (palpate::DrawnFrequency). Default 20.
  vtkSetClampMacro(Frequency, int, 1, 1000);
  vtkGetMacro(Frequency, int);
  ///@}

protected:
  vtkModelReader() { this->SetNumberOfInputPorts(0); }
  ~vtkModelReader() override { this->SetFileName(nullptr); }

  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkModelReader(const vtkModelReader&) = delete;
  void operator=(const vtkModelReader&) = delete;

  char* FileName = nullptr;
  int Frequency = 20;
};

#endif
