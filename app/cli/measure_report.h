// measure_report.h -- what was measured, as CSV, JSON, plots and a page to read.
#pragma once

#include <string>
#include <vector>

#include "app/cli/print.h"
#include "app/measure/measure.h"

namespace pelage {

// Where and on what a measurement was made.
struct ReportHead {
    std::string model, preset;  // preset may be empty
    std::string date;           // 2026-11-22
    std::string processor;
    unsigned cores = 0;
};

// The figures, with what the noise of the reference is of them.
OrderedJson errorsJson(const ImageErrors& errors, const TracedPicture& reference);

// Everything but the pictures. `rows` holds one object for each value, view and technique.
OrderedJson reportJson(const ReportHead& head, const Measurement& measurement);

// The rows of that object, one line each; what is an object in them becomes columns like
// "drawing.rmse", what is null an empty field.
std::string reportCsv(const OrderedJson& report);

// ms of a picture against the mean FLIP of drawing, one plot for each view.
std::string reportPlot(const ReportHead& head, const Measurement& measurement);

// A page of HTML that needs no other file.
std::string reportPage(const ReportHead& head, const Measurement& measurement);

// "2 cores of AMD EPYC; llvmpipe ...; 2026-11-22"
std::string machineText(const ReportHead& head, const Measurement& measurement);

// Which rows of a view no faster one is as exact as, by FLIP of drawing.
std::vector<bool> onFront(const MeasuredEye& eye);

// ms of a picture against FLIP and against RMSE of drawing, in one view.
std::string eyePlots(const ReportHead& head, const Measurement& measurement,
                     const MeasuredEye& eye);

}  // namespace pelage
