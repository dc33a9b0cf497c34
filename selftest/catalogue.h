/// The parts of the catalogue.
#pragma once

#include "selftest/fault.h"

namespace zproof::selftest {

std::vector<Fault> clean_frames();       ///< nothing is wrong, or only the reference is
std::vector<Fault> faults_of_a_pixel();  ///< one pixel among millions
std::vector<Fault> faults_of_ids();
std::vector<Fault> faults_of_depth();
std::vector<Fault> faults_of_attributes();
std::vector<Fault> faults_of_place();       ///< right answers at the wrong pixels
std::vector<Fault> faults_of_visibility();  ///< the wrong one of several surfaces

}  // namespace zproof::selftest
