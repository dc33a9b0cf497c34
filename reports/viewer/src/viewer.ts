import {makeTablesSortable} from './sortable'; makeTablesSortable(document);
