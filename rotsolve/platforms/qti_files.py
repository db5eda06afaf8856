class QtiFiles: pass
