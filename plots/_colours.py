"""Colours of vorticity and pressure: white where there is none."""

from matplotlib.colors import LinearSegmentedColormap

BLUES = ["#1f5fa8", "#3d87c0", "#7db6da", "#b9d9ec", "#e1eff7", "#ffffff"]
REDS = ["#ffffff", "#fdebe1", "#fac9b0", "#ef9a7c", "#d75f50", "#b3202f"]
COLOURS = LinearSegmentedColormap.from_list("vorticity", BLUES + REDS[1:])
UPPER = LinearSegmentedColormap.from_list("positive", REDS)
LOWER = LinearSegmentedColormap.from_list("negative", BLUES)
