/// Reports of a run. Every report is a pure function of Results and the files beside them. This header opens
/// all of them at once; each has one of its own.
#pragma once

#include "reports/evidence.h"
#include "reports/html.h"
#include "reports/json.h"
#include "reports/junit.h"
#include "reports/output_folder.h"
#include "reports/report_error.h"
#include "reports/results.h"
#include "reports/terminal.h"
