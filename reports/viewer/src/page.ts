// Entry for pages of tables and pictures: nothing of the viewer.
import {linkCharts} from './charts';
import {linkCrops} from './crops';
import {makeTablesSortable} from './sortable';

makeTablesSortable(document);
linkCrops(document);
linkCharts(document);
