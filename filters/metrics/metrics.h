/// The metrics, a file for each family.
#pragma once

#include "filters/metrics/picture_metric.h"

namespace zproof {

PictureMetric rmse_metric();
PictureMetric psnr_metric();
PictureMetric mae_metric();
PictureMetric p99_metric();
PictureMetric max_metric();
PictureMetric flip_metric();
PictureMetric ssim_metric();
PictureMetric bias_metric();
PictureMetric blur_metric();
PictureMetric alias_metric();
PictureMetric stops_metric();
PictureMetric flip_tone_metric();

}  // namespace zproof
