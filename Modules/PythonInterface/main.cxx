#include "Call.h"
#include "CheckBinding.h"
#include "ComparisonBinding.h"
#include "CorrectionBinding.h"
#include "FieldBinding.h"
#include "GeodesicsBinding.h"
#include "ModelBinding.h"
#include "RegistrationBinding.h"
#include "SceneBinding.h"
#include "SessionBinding.h"
#include "StatisticsBinding.h"

#include "palpate.h"

#include <pybind11/pybind11.h>

PYBIND11_MODULE(_kernels, module)
{
  module.doc() = "Palpate's interface for C over NumPy arrays; import palpate instead.";
  pybind11::register_exception<palpate::CallError>(module, "Error", PyExc_RuntimeError).doc() =
      "What Palpate refuses, as one sentence.";
  module.attr("__version__") = palpate_version();
  palpate::BindModels(module);
  palpate::BindCorrections(module);
  palpate::BindGeodesics(module);
  palpate::BindComparisons(module);
  palpate::BindRelations(module);
  palpate::BindRegistrations(module);
  palpate::BindChecks(module);
  palpate::BindFields(module);
  palpate::BindScenes(module);
  palpate::BindSessions(module);
  palpate::BindStatistics(module);
}
